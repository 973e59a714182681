// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/listing/listing.hpp"

namespace torsor {

/// A member of Precomputed.
struct PrecomputedMember {
  std::string name;
  std::string meaning;
};

/// Puts together what several functions need computed once for a set of parameters: one listing of all their members of
/// Precomputed, in which what is computed alike stands once.
///
/// A member is called after its formula, by a digest of all that it is computed from: a function reads it under the same
/// name whichever other functions there are.
class Precomputation {
 public:
  /// Adds what one function needs. Returns, for each output of the listing, the member that it became.
  std::vector<std::size_t> add(const Listing& once);

  const std::vector<PrecomputedMember>& members() const { return members_; }
  /// The listing of all that was added; its targets are members of "precomputed".
  const Listing& listing() const { return listing_; }

 private:
  /// Of what is added: quantities of the listing here, by quantity of the one that is added.
  using Places = std::vector<ValueNumber>;

  /// The quantity of this formula; a new one gets a statement, made by `statement` of its number.
  template <class MakeStatement>
  ValueNumber quantity(const std::string& formula, const std::string& content, const std::string& name,
                const MakeStatement& statement);
  void define(const Listing& once, const Assigned& each, Places& places);
  void define(const Listing& once, const Literal& each, Places& places);
  void define(const Listing& once, const Pi& each, Places& places);
  void define(const Listing& once, const SinesAndCosines& group, Places& places);
  ValueNumber turned(const std::string& name, const char* function, ValueNumber angle);
  std::string local_name(const std::string& name);  ///< anew where it is a number
  ValueNumber add(Quantity quantity, const std::string& formula, const std::string& content);
  std::string exactly(const Formula& formula) const;  ///< in quantities of this listing
  std::string content(const Formula& formula) const;  ///< whatever the numbers of these

  Listing listing_;
  std::vector<PrecomputedMember> members_;
  std::vector<std::string> contents_;          ///< of each quantity: a digest of what it is computed from
  std::map<std::string, ValueNumber> quantities_;     ///< by formula
  std::map<std::string, std::size_t> places_;  ///< of members, by formula
  std::size_t numbered_ = 0;
};

}  // namespace torsor
