// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "torsor/generator/program/series_program.hpp"

namespace torsor {

/// Turns the live part of a program into operations between series: one way of doing it for each choice of definitions
/// that are multiplied into the sums and products that use them instead of being computed.
class SeriesLowering {
 public:
  /// `live` in the program's order; `inlined` by value number.
  SeriesLowering(const Program& program, const std::vector<ValueNumber>& live, std::vector<bool> inlined);

  void add_output(const Polynomial& polynomial);
  /// Nodes that some output needs, and the outputs.
  std::pair<std::vector<SeriesNode>, std::vector<SeriesForm>> take();

 private:
  struct Power {
    int node;
    int exponent;
    friend bool operator==(const Power&, const Power&) = default;
  };
  struct Product {
    Polynomial coefficient;
    std::vector<Power> powers;  ///< by node, no exponent zero

    void multiply(int node, int exponent);
  };
  /// coefficient · value number, if there is a value number, else a product.
  struct Piece {
    Product product;
    std::optional<ValueNumber> value_number;
  };
  struct Scaled {
    Polynomial coefficient;
    int node;
  };

  void define(ValueNumber value_number);
  void define_function(ValueNumber value_number);
  void define_arctangent(ValueNumber value_number, std::optional<int> y, std::optional<int> x);
  bool is_constant(const Polynomial& polynomial) const;
  std::vector<Piece> pieces_of(const Polynomial& polynomial);
  std::vector<Product> multiplied(const Term& term, const Number& coefficient);
  bool is_multiplied_in(const Factor& factor, std::size_t times) const;
  const SeriesForm& form_of(ValueNumber value_number);
  SeriesForm lowered(const std::vector<Piece>& pieces, SeriesForm& expanded);
  SeriesForm lowered(std::vector<Product> products);
  void unite_squares(std::vector<Product>& products) const;
  void unite_quotients(std::vector<Product>& products) const;
  Product in_factors(const Product& product) const;
  void multiply_by_factors(Product& result, int node, int exponent) const;
  SeriesForm taken_out(std::pair<int, bool> factor, std::vector<Product> inside);
  Scaled scaled(const SeriesForm& form);
  int exact(const SeriesForm& form);
  int product(int left, int right);
  int quotient(std::optional<int> dividend, int divisor);
  std::optional<int> known_product(const std::vector<Power>& powers) const;
  int value_of(const std::vector<Power>& powers);
  void multiply(Product& product, ValueNumber value_number, int exponent);
  void multiply_by_node(Product& product, int node, int exponent) const;
  static void add(std::vector<Product>& sum, Product product);
  int append(SeriesNode node);

  const Program& program_;
  std::vector<bool> inlined_;                      ///< by value number
  std::vector<bool> constant_;                     ///< by value number
  std::vector<std::vector<Piece>> pieces_;         ///< by value number, of sums
  std::vector<std::optional<SeriesForm>> direct_;  ///< by value number: in terms of what it was written with
  std::vector<SeriesForm> expanded_;               ///< by value number: with sums put back, where that stays short
  std::map<std::pair<int, int>, int> products_;
  std::map<std::pair<std::optional<int>, int>, int> quotients_;
  std::multimap<int, int> sums_;  ///< by first node, looked up only
  std::vector<SeriesNode> nodes_;
  std::vector<SeriesForm> outputs_;
};

}  // namespace torsor
