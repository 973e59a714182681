// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

// By start.c
extern "C" void say(const char* text);  ///< to the debugger, or QEMU's terminal
extern "C" void finish(int code);

/// The clock that every Cortex-M has (SysTick): it counts down, 24 bits.
struct Clock {
  static volatile std::uint32_t& at(std::uintptr_t address) noexcept {
    return *reinterpret_cast<volatile std::uint32_t*>(address);
  }
  /// With an interrupt, tick(), each `period` cycles of the processor; without one where asked for none.
  static void start(std::uint32_t period, bool interrupts) noexcept {
    at(0xe000e014) = period - 1;
    at(0xe000e018) = 0;
    at(0xe000e010) = interrupts ? 7 : 5;
  }
  static std::uint32_t now() noexcept { return at(0xe000e018); }
};

/// A number in a line of text, with so many decimals; |number| below 10^5.
inline void say_number(float number, int decimals) noexcept {
  char text[24];
  int length = 0;
  if (number < 0) text[length++] = '-', number = -number;
  float power = 1;
  for (int i = 0; i < decimals; ++i) power *= 10.0f;
  auto digits = static_cast<std::uint32_t>(number * power + 0.5f);
  std::uint32_t highest = 1;
  for (int i = 0; i < decimals; ++i) highest *= 10;
  while (digits / highest >= 10) highest *= 10;
  for (int place = 0; highest > 0; highest /= 10, ++place) {
    text[length++] = static_cast<char>('0' + digits / highest % 10);
    std::uint32_t point = 1;
    for (int i = 0; i < decimals; ++i) point *= 10;
    if (highest == point && decimals > 0) text[length++] = '.';
  }
  text[length] = 0;
  say(text);
}
