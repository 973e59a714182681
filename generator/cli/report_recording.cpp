// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/base/base64.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/printable.hpp"
#include "torsor/generator/cli/contact_simulation.hpp"
#include "torsor/generator/cli/report.hpp"

namespace torsor {
namespace {

using Json = nlohmann::ordered_json;

/// Bytes of doubles, the lowest first, whatever this machine's are.
std::string numbers_as_text(const std::vector<double>& numbers) {
  std::string bytes;
  for (const double number : numbers) {
    auto bits = std::bit_cast<std::uint64_t>(number);
    for (int i = 0; i < 8; ++i, bits >>= 8U) bytes += static_cast<char>(bits & 0xffU);
  }
  return base64(bytes);
}

/// Time between samples: 60 a second, 600 at least for short motions, and as many as a page has room for.
double interval_of(double duration, std::size_t numbers) {
  constexpr double most = 40'000.0;  // numbers; 10.7 characters each
  const double wanted = std::max(600.0, std::ceil(60 * duration)), room = std::floor(most / static_cast<double>(numbers));
  return duration / std::max(2.0, std::min(wanted, room));
}

/// Columns of a motion, row by row.
std::string columns_as_text(const Simulation& motion, std::size_t first, std::size_t count) {
  std::vector<double> numbers;
  for (const std::vector<double>& row : motion.rows) {
    for (std::size_t i = first; i < first + count; ++i) numbers.push_back(row[i]);
  }
  return numbers_as_text(numbers);
}

/// An index into the words of Playback.eventInWords (templates/report/playback.js).
int number_of(ContactRecord::EventKind kind) { return static_cast<int>(kind); }

}  // namespace

std::string report_recording(const Scene& scene, const ReportOptions& given) {
  const SceneContent& content = scene.content();
  std::size_t numbers = 2 * content.coordinates.size() + 8 * content.attitudes.size() + 4 * content.contacts.size();
  SimulationOptions options;
  options.model = given.model;
  options.duration = given.duration;
  options.initial = given.initial;
  options.inputs = given.inputs;
  options.step = interval_of(given.duration, std::max<std::size_t>(1, numbers));
  const ContactRecord record = record_contacts(scene, options, given.language);
  const Simulation& motion = record.motion;
  std::vector<std::string> remarks = motion.remarks;
  if (!record.inputs.empty()) {
    std::vector<std::string> values;
    for (const std::string& name : record.inputs) {
      const auto value = given.inputs.find(name);
      values.push_back(fmt::format("{} = {}", name, value == given.inputs.end() ? 0.0 : value->second));
    }
    remarks.insert(remarks.begin(), given.language("inputs are constant: {}", printable(fmt::format("{}", fmt::join(values, ", ")))));
  }
  if (motion.rows.empty()) throw Error(motion.status);
  std::size_t of_contacts = 0;
  Json contacts = Json::array();
  for (const ContactRecord::Contact& contact : record.contacts) {
    of_contacts += (contact.normal ? 1 : 0) + contact.reactions.size();
    contacts.push_back({{"name", printable(contact.name)},
                        {"normal", contact.normal},
                        {"reactions", contact.reactions},
                        {"gapUnit", contact.gap_unit},
                        {"unit", contact.unit}});
  }
  Json regimes = Json::array();
  for (std::size_t k = 0; k < record.regimes.size(); ++k) {
    if (k == 0 || record.regimes[k] != record.regimes[k - 1]) regimes.push_back({k, record.regimes[k]});
  }
  constexpr std::size_t most_events = 2000;
  Json events = Json::array();
  for (std::size_t k = 0; k < std::min(most_events, record.events.size()); ++k) {
    const ContactRecord::Event& event = record.events[k];
    events.push_back({event.time, number_of(event.kind), event.contact, event.energy_lost, event.after});
  }
  return Json{{"interval", options.step},
              {"count", motion.rows.size()},
              {"numbers", record.numbers},
              {"states", columns_as_text(motion, 1, record.numbers)},
              {"contacts", contacts},
              {"contactNumbers", of_contacts},
              {"contactStates", columns_as_text(motion, motion.names.size() - of_contacts, of_contacts)},
              {"regimes", regimes},
              {"events", events},
              {"eventCount", record.events.size()},
              {"status", motion.status},
              {"remarks", remarks}}
      .dump();
}

}  // namespace torsor
