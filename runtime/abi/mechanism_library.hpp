// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>
#include <utility>

#include "torsor/runtime/abi.h"
#include "torsor/runtime/abi/kernel_call.hpp"
#include "torsor/runtime/abi/motion_call.hpp"
#include "torsor/runtime/abi/operands.hpp"
#include "torsor/runtime/abi/size_check.hpp"
#include "torsor/runtime/batch/simd.hpp"
#ifdef TORSOR_ABI_WITH_CONTACTS
#include "torsor/runtime/abi/contact_call.hpp"
#endif

namespace torsor::runtime::abi {

struct NoContacts {
  static constexpr std::array<torsor_abi_contact, 0> contacts{};
};

/// The table of runtime/abi.h for one generated mechanism, and for the contacts of its scene. Whoever compiles a
/// mechanism with contacts defines TORSOR_ABI_WITH_CONTACTS. With Sizes the last kernel is `run_time_sizes`, which the table
/// does not show: parameters are compared by it.
template <template <class> class Mechanism, class Contacts = NoContacts, class Sizes = NoSizes>
class MechanismLibrary {
  using Single = Mechanism<double>;
  using Packed = Mechanism<NativeSimd<double>>;
  using Description = typename Single::Description;

  static constexpr bool moves = HasForwardDynamics<Single>;
  static constexpr bool touches = !Contacts::contacts.empty();
#ifdef TORSOR_ABI_WITH_CONTACTS
  static constexpr bool moves_contacts = touches && MovesContacts<Single>;
#else
  static constexpr bool moves_contacts = false;
  static_assert(!touches, "a mechanism with contacts is compiled with TORSOR_ABI_WITH_CONTACTS");
#endif
  static constexpr bool compares = !Sizes::sizes.empty();
  static constexpr std::size_t described = Description::kernels.size() - (compares ? 1 : 0);
  static constexpr std::size_t kernel_count = described + (moves ? 1 : 0);
  static constexpr std::size_t described_results = Description::results.size() - (compares ? 1 : 0);
  static constexpr std::size_t result_count = described_results + (moves ? 1 : 0);
  static constexpr std::size_t parameter_count = static_cast<std::size_t>(Single::parameter_count);

  struct Model {
    typename Single::Parameters parameters;
    typename Single::Precomputed single;
    typename Packed::Precomputed packed;
    std::array<char, 512> impossible;  ///< what is, of these parameters; empty: nothing
  };

 public:
  /// Made at the first call; the caller keeps it.
  [[nodiscard]] static const torsor_abi& table() noexcept {
    static const MechanismLibrary library;
    return library.abi_;
  }

 private:
  MechanismLibrary() noexcept {
    describe_kernels();
    const typename Single::Parameters defaults = Single::default_parameters();
    if constexpr (parameter_count > 0) std::memcpy(parameters_.data(), &defaults, parameter_count * sizeof(double));
    abi_.version = TORSOR_ABI_VERSION;
    abi_.size = sizeof(torsor_abi);
    abi_.name = Single::name;
    abi_.fingerprint = Single::fingerprint;
    abi_.lanes = native_lanes<double>;
    abi_.coordinate_count = Single::coordinate_count;
    abi_.velocity_count = Single::velocity_count;
    abi_.input_count = Single::input_count;
    abi_.multiplier_count = Single::multiplier_count;
    abi_.parameter_count = Single::parameter_count;
    abi_.coordinates = list(Description::coordinates, coordinates_);
    abi_.velocities = list(Description::velocities, velocities_);
    abi_.inputs = list(Description::inputs, inputs_);
    abi_.multipliers = list(Description::multipliers, multipliers_);
    abi_.parameters = list(Description::parameters, names_of_parameters_);
    abi_.default_parameters = parameters_.data();
    if constexpr (HasQuaternions<Single>) {
      static constexpr auto places = [] {
        std::array<std::int32_t, static_cast<std::size_t>(Single::quaternion_count)> all{};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = Single::quaternions[i];
        return all;
      }();
      abi_.quaternion_count = Single::quaternion_count;
      abi_.quaternions = places.data();
    }
    abi_.kernel_count = static_cast<std::int32_t>(kernel_count);
    abi_.kernels = kernels_.data();
    set_methods();
    abi_.create = create;
    abi_.destroy = destroy;
    abi_.initial_state = initial_state;
    abi_.integrate = integrate;
    abi_.contact_count = static_cast<std::int32_t>(Contacts::contacts.size());
    for (const torsor_abi_contact& each : Contacts::contacts) abi_.contact_row_count += each.normal + each.tangents;
    abi_.contacts = Contacts::contacts.data();
    if (touches) abi_.integrate_contacts = integrate_contacts;
    abi_.impossible = impossible;
  }

  void set_methods() noexcept {
    const auto set = [this](const auto& table, bool usable) {
      abi_.method_count = usable ? static_cast<std::int32_t>(table.size()) : 0;
      abi_.methods = table.data();
    };
#ifdef TORSOR_ABI_WITH_CONTACTS
    if (touches) return set(contact_methods, moves_contacts);
#endif
    set(methods, moves);
  }

  template <class Quantities, std::size_t size>
  static const torsor_abi_quantity* list(const Quantities& from, std::array<torsor_abi_quantity, size>& to) noexcept {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = {from[i].name, from[i].unit};
    return to.data();
  }

  void describe_kernels() noexcept {
    std::size_t next = 0;
    for (const auto& result : Description::results) {
      if (next == described_results) break;
      results_[next++] = {result.member[0] == '\0' ? result.result : result.member, result.rows, result.columns,
                          result.dimensions, result.unit};
    }
    std::size_t first = 0;
    for (std::size_t k = 0; k < described; ++k) {
      const auto& kernel = Description::kernels[k];
      add_kernel(k, kernel.name,
                 {kernel.reads_accelerations, kernel.reads_multipliers, kernel.reads_inputs, results_.data() + first,
                  writers.data() + first, static_cast<std::size_t>(kernel.result_count)},
                 kernel.has_status);
      first += static_cast<std::size_t>(kernel.result_count);
    }
    std::size_t k = 0;
    Single::for_each_kernel([&](const auto&, auto* function) {
      if (k < described) calls()[k++].single = any_kernel<Single>(function);
    });
    k = 0;
    Packed::for_each_kernel([&](const auto&, auto* function) {
      if (k < described) calls()[k++].packed = any_kernel<Packed>(function);
    });
    if constexpr (moves) {
      results_[first] = {"derivative", Single::coordinate_count + Single::velocity_count, 1, 1, ""};
      add_kernel(described, "state_derivative",
                 {false, false, true, results_.data() + first, writers.data() + first, 1}, true);
      calls()[described].single = any_kernel<Single>(&derivative<Single>);
      calls()[described].packed = any_kernel<Packed>(&derivative<Packed>);
    }
    for (std::size_t i = 0; i < kernel_count; ++i) {
      kernels_[i].takes_order = calls()[i].single.scalars_of_orders > 0 ? 1 : 0;
    }
    name_functions(std::make_index_sequence<kernel_count>{});
  }

  template <class M>
  static auto derivative(const typename M::Precomputed& precomputed, const typename M::State& state,
                         const typename M::Inputs& inputs, StateVector<M>& result) noexcept {
    return state_derivative<M>(precomputed, state, inputs, result);
  }

  void add_kernel(std::size_t k, const char* name, const KernelShape& shape, bool has_status) noexcept {
    calls()[k].shape = shape;
    kernels_[k] = {name,
                   shape.reads_accelerations,
                   shape.reads_multipliers,
                   shape.reads_inputs,
                   has_status,
                   0,
                   static_cast<std::int32_t>(shape.result_count),
                   shape.results,
                   nullptr};
  }

  template <std::size_t... k>
  void name_functions(std::index_sequence<k...>) noexcept {
    ((kernels_[k].evaluate = evaluate<k>), ...);
  }

  template <std::size_t k>
  static std::int64_t evaluate(torsor_call* call) {
    if (call->model == nullptr) return torsor_call_without_model;
    const Model& model = *reinterpret_cast<const Model*>(call->model);
    if (model.impossible[0] != '\0') return torsor_call_impossible_parameters;
    return calls()[k](model.single, model.packed, *call);
  }

  /// How results are written from packs, in the order of the description.
  template <int rows, int columns>
  static constexpr ResultWriter writer() noexcept {
    if constexpr (rows > 0 && columns > 0) {
      return write_matrices_of<native_lanes<double>, static_cast<std::size_t>(rows), static_cast<std::size_t>(columns)>;
    } else {
      return nullptr;
    }
  }
  static constexpr std::array<ResultWriter, result_count> writers = []<std::size_t... r>(std::index_sequence<r...>) {
    std::array<ResultWriter, result_count> all{
        writer<Description::results[r].rows, Description::results[r].columns>()...};
    if (moves) all.back() = writer<Single::coordinate_count + Single::velocity_count, 1>();
    return all;
  }
  (std::make_index_sequence<described_results>{});

  using Calls = std::array<KernelCall<Single, Packed>, kernel_count>;
  static Calls& calls() noexcept {
    static Calls all{};
    return all;
  }

  static torsor_model* create(const double* parameters) {
    Model* const model = new (std::nothrow) Model{};
    if (model == nullptr) return nullptr;
    model->parameters = Single::default_parameters();
    if constexpr (parameter_count > 0) {
      static_assert(sizeof(model->parameters) == parameter_count * sizeof(double));
      if (parameters != nullptr) std::memcpy(&model->parameters, parameters, parameter_count * sizeof(double));
    }
    model->single = Single::precompute(model->parameters);
    typename Packed::Parameters packs{};
    if constexpr (parameter_count > 0) {
      for (std::size_t k = 0; k < parameter_count; ++k) {
        double number;
        std::memcpy(&number, reinterpret_cast<const char*>(&model->parameters) + k * sizeof(double), sizeof(double));
        packs[static_cast<int>(k)] = NativeSimd<double>(number);
      }
    }
    model->packed = Packed::precompute(packs);
    if constexpr (compares) compare(*model);
    return reinterpret_cast<torsor_model*>(model);
  }

  static void compare(Model& model) noexcept {
    std::array<double, Sizes::numbers> numbers;
    Single::run_time_sizes(model.single, typename Single::State{}, numbers);
    for (const SizeCheck& size : Sizes::sizes) {
      if (size.broken(numbers)) return size.say(model.impossible, numbers);
    }
  }

  static const char* impossible(const torsor_model* model) {
    const char* const said = reinterpret_cast<const Model*>(model)->impossible.data();
    return said[0] == '\0' ? nullptr : said;
  }

  static void destroy(torsor_model* model) { delete reinterpret_cast<Model*>(model); }

  static void initial_state(const torsor_model* model, double* time, double* q, double* v) {
    const auto state = initial_state_with<Single>(reinterpret_cast<const Model*>(model)->parameters);
    if (time != nullptr) *time = state.time;
    for (int i = 0; q != nullptr && i < Single::coordinate_count; ++i) q[i] = state.q[i];
    for (int i = 0; v != nullptr && i < Single::velocity_count; ++i) v[i] = state.v[i];
  }

  static std::int64_t integrate(const torsor_motion* motion) {
    if constexpr (touches) {
      torsor_contact_motion with_contacts{};
      with_contacts.motion = *motion;
      return integrate_contacts(&with_contacts);
    } else if constexpr (moves) {
      if (motion->model == nullptr) return torsor_call_without_model;
      if (impossible(motion->model) != nullptr) return torsor_call_impossible_parameters;
      return MotionCall<Single>(reinterpret_cast<const Model*>(motion->model)->parameters, *motion)();
    } else {
      return motion->model == nullptr ? torsor_call_without_model : torsor_call_without_kernels;
    }
  }

  static std::int64_t integrate_contacts(const torsor_contact_motion* motion) {
    if (motion->motion.model == nullptr) return torsor_call_without_model;
    if (impossible(motion->motion.model) != nullptr) return torsor_call_impossible_parameters;
#ifdef TORSOR_ABI_WITH_CONTACTS
    if constexpr (moves_contacts) {
      return ContactCall<Single>(reinterpret_cast<const Model*>(motion->motion.model)->parameters, *motion)();
    }
#endif
    return torsor_call_without_kernels;
  }

  template <class Quantities>
  using List = std::array<torsor_abi_quantity, std::tuple_size_v<std::remove_cvref_t<Quantities>>>;
  List<decltype(Description::coordinates)> coordinates_;
  List<decltype(Description::velocities)> velocities_;
  List<decltype(Description::inputs)> inputs_;
  List<decltype(Description::multipliers)> multipliers_;
  List<decltype(Description::parameters)> names_of_parameters_;
  std::array<double, parameter_count> parameters_;
  std::array<torsor_abi_result, result_count> results_;
  std::array<torsor_abi_kernel, kernel_count> kernels_;
  torsor_abi abi_{};
};

}  // namespace torsor::runtime::abi
