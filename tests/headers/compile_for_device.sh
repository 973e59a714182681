#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# compile_for_device.sh HEADER KERNEL RESULT FOLDER: nvcc compiles a kernel of the header for the device, in double and
# in float, with TORSOR_DEVICE and without a warning. Ends with 77 (skipped) when nvcc is not installed.
set -euo pipefail
header="$1" kernel="$2" result="$3" folder="$4"
nvcc="$(command -v nvcc || echo "${CUDA_HOME:-/usr/local/cuda}/bin/nvcc")"
[ -x "$nvcc" ] || { echo "nvcc is not installed"; exit 77; }
mkdir -p "$folder"
mechanism="$(basename "$header" .hpp)::Mechanism"
cat > "$folder/device.cu" <<END
#define TORSOR_DEVICE __host__ __device__
#include "$header"
template <class Scalar, class M = $mechanism<Scalar>>
__global__ void every_state(typename M::Precomputed precomputed, const typename M::State* states, typename M::$result* results) {
  M::$kernel(precomputed, states[threadIdx.x], results[threadIdx.x]);
}
template __global__ void every_state<double>($mechanism<double>::Precomputed, const $mechanism<double>::State*,
                                             $mechanism<double>::$result*);
template __global__ void every_state<float>($mechanism<float>::Precomputed, const $mechanism<float>::State*,
                                            $mechanism<float>::$result*);
END
"$nvcc" -std=c++17 -O2 -Werror all-warnings -c "$folder/device.cu" -o "$folder/device.o"
echo "$(basename "$header"): $kernel compiled for the device"
