// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/listing/computation.hpp"

namespace torsor {

/// What a member means, its frame where it has one, and its unit where all entries have the same.
struct Meaning {
  Meaning(const char* given) : text(given) {}
  Meaning(std::string given, std::string its_unit = "") : text(std::move(given)), unit(std::move(its_unit)) {}

  /// As documentation shows it: "kinetic energy T [J]".
  std::string with_unit() const { return unit.empty() ? text : text + " [" + unit + "]"; }

  std::string text;
  std::string unit{};  ///< as a person writes it; empty: none is stated
};

/// A vector and a matrix are arrays of rows * columns numbers; what has one column may be either.
enum class Shape { scalar, vector, matrix };

/// One member of a result structure: a scalar, a vector, or a matrix stored column by column.
struct Member {
  std::string name;
  int rows = 1;
  int columns = 1;
  Meaning meaning;
  Shape shape = Shape::scalar;

  bool is_scalar() const { return shape == Shape::scalar; }
};

/// Constants that come along with a structure: a number, or a table of indices or of factors.
struct ConstantTable {
  using Indices = std::vector<std::size_t>;
  using Factors = std::vector<double>;

  std::string name;
  std::variant<std::size_t, Indices, Factors> value;
  std::string documentation{};  ///< of this one, and of those behind it that have none; one or more lines
};

/// A structure of the generated header that one kernel brings along.
struct Structure {
  std::string name;
  std::string documentation;
  std::vector<Member> members;
  std::vector<ConstantTable> tables{};
};

/// What a kernel reads besides `precomputed` and `state`.
enum class Argument { accelerations, multipliers, inputs };

/// What a kernel writes: a structure, or an array.
struct Result {
  std::string structure;  ///< "GeneralizedForces", or the name of a structure of the kernel; empty for an array
  std::string name;
  std::size_t size = 0;                  ///< of an array
  std::optional<std::size_t> columns{};  ///< of an array that is a matrix
};

/// What a caller of a kernel must know.
struct KernelSignature {
  std::string name;
  std::string documentation;  ///< one or more lines: equation, layout, units
  std::vector<Argument> arguments;
  std::vector<Structure> structures;
  std::vector<Result> results;
};

/// A kernel as values of the equations' program: it is lowered to a listing, counted and evaluated.
struct Kernel : KernelSignature, Computation {
  std::string skipped{};  ///< not empty: why there is nothing to compute; the kernel is absent from the header
};

/// Names of all kernels, in the order of the header.
const std::vector<std::string>& kernel_names();

/// Those that `all` stands for: second derivatives and sensitivities are made only when they are named.
const std::vector<std::string>& usual_kernel_names();

/// Whether the kernel solves with the mass matrix, and so is absent where joints move no mass.
bool solves_with_mass_matrix(const std::string& name);

/// Builds a kernel on the equations' program, as it is derived: no pass has been at its results.
/// Throws UsageError naming an unknown kernel and listing the known ones.
Kernel derive_kernel(const std::string& name, const Equations& equations);

/// The same after the passes on results.
Kernel make_kernel(const std::string& name, const Equations& equations);
/// The passes on results; then these have the limits of limits_at_roots.hpp.
void run_passes_on_results(Program& program, Computation& computation);

/// A kernel with equations of its own: as it is emitted, whichever other kernels there are.
struct OwnKernel {
  std::unique_ptr<const Equations> equations;
  Kernel kernel;
};
/// Those that are not absent.
std::vector<OwnKernel> make_own_kernels(const Scene& scene, const ModelOptions& options,
                                        const std::vector<std::string>& names);

/// Why a kernel is absent, empty where it is not; no kernel is derived for it.
std::string why_absent(const std::string& name, const Equations& equations);

/// Splits a comma-separated list, "all" meaning usual_kernel_names; checks the names and removes repetitions.
std::vector<std::string> parse_kernel_list(const std::string& list);

}  // namespace torsor
