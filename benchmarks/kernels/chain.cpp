// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/kernels/chain.hpp"

#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace kernels {

std::vector<Chain> read_chains(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read '" + path + "': does the file exist?");
  std::vector<Chain> chains;
  try {
    const nlohmann::json json = nlohmann::json::parse(file);
    for (const nlohmann::json& model : json.at("models")) {
      Chain chain{model.at("name"), json.at("gravity"), {}};
      for (const nlohmann::json& joint : model.at("joints")) {
        const int axis = joint.at("axis").get<std::string>().at(0) - 'x';
        chain.joints.push_back(
            {joint.at("R"), joint.at("p"), axis, joint.at("mass"), joint.at("com"), joint.at("inertia")});
      }
      chains.push_back(std::move(chain));
    }
  } catch (const std::exception& error) {
    throw std::runtime_error("'" + path + "' does not hold chains: " + error.what());
  }
  return chains;
}

}  // namespace kernels
