// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "torsor/runtime/small_motions/linear_system.hpp"

namespace torsor::runtime {

/// Natural modes of M x'' + K x = 0: K Q = M Q diag(ω²), slowest first, normalised by the masses:
///   Qᵀ M Q = 1,  Qᵀ K Q = diag(ω²).
/// Q is no rotation: with D = M⁻¹ K it is Q⁻¹ D Q that is diagonal, and Qᵀ D Q is not (Pommier, §7.3.2, corrected).
struct NaturalModes {
  Eigen::VectorXd squared_frequencies;  ///< ω² [rad²/s²]; negative where the motion runs away, 0 for a free motion,
                                        ///< which is one where no more than 4 n ε of the largest is left
  Eigen::MatrixXd shapes;               ///< Q, one mode a column, its largest share of the mass counted positive

  /// ω of a mode [rad/s]; not a number where ω² < 0.
  [[nodiscard]] double angular_frequency(Eigen::Index mode) const {
    const double square = squared_frequencies(mode);
    return square < 0.0 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(square);
  }
};

/// Modes of a conservative system about a stable or unstable rest. C is not looked at. Throws std::invalid_argument for
/// matrices without natural modes: M not positive definite, K not symmetric (use `damped_modes`).
[[nodiscard]] NaturalModes natural_modes(const LinearSystem& system);

/// One root of det(M λ² + C λ + K) = 0 with its shape: x(t) = Re(c φ e^{λ t}).
struct DampedMode {
  std::complex<double> eigenvalue;  ///< λ [1/s]
  Eigen::VectorXcd shape;           ///< φ, its entry of the largest share of the mass is 1
  double residual = 0.0;            ///< ‖(M λ² + C λ + K) φ‖ in units without dimension, σ² ‖φ‖ = 1

  [[nodiscard]] double angular_frequency() const { return std::abs(eigenvalue.imag()); }  ///< of the oscillation
  /// ζ = −Re λ / |λ|: 1 and more is a motion without oscillation; not a number for λ = 0.
  [[nodiscard]] double damping_ratio() const { return -eigenvalue.real() / std::abs(eigenvalue); }
};

/// All 2 n modes of M x'' + C x' + K x = 0, for any C (dissipative, gyroscopic) and any K, by the eigenvalues of the
/// state matrix in normalised coordinates; smallest |λ| first, of two conjugate ones that with Im λ > 0. The shape of a
/// multiple root that lacks eigenvectors repeats another one. Throws std::invalid_argument as `normalised` does.
[[nodiscard]] std::vector<DampedMode> damped_modes(const LinearSystem& system);

/// C = α M + β K fitted to a damping matrix by least squares in normalised coordinates.
struct ProportionalDamping {
  double alpha = 0.0;     ///< [1/s]
  double beta = 0.0;      ///< [s]
  double residual = 0.0;  ///< ‖C − α M − β K‖ / ‖C‖: 0 within rounding when the damping is proportional
};

[[nodiscard]] ProportionalDamping proportional_damping(const LinearSystem& system);

/// How damping acts on natural modes: Qᵀ C Q = diag(2 ζ ω) when it is proportional, or more generally when
/// C M⁻¹ K = K M⁻¹ C; each mode then moves on its own.
struct ModalDamping {
  Eigen::VectorXd rates;   ///< diagonal of Qᵀ C Q [1/s]
  Eigen::VectorXd ratios;  ///< ζ_i = rates_i / (2 ω_i); not a number where ω² <= 0
  double coupling = 0.0;   ///< largest entry off the diagonal of Qᵀ C Q, relative to the largest on it
};

[[nodiscard]] ModalDamping modal_damping(const NaturalModes& modes, const Eigen::MatrixXd& C);

}  // namespace torsor::runtime
