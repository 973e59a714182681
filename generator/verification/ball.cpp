// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/ball.hpp"

#include "torsor/generator/base/error.hpp"

#ifdef TORSOR_WITH_ARB

#include <sstream>
#include <string>

#include <arb.h>
#include <cln/integer_io.h>
#include <cln/rational.h>

namespace torsor {
namespace {

slong bits() { return static_cast<slong>(3.33 * Real::working_digits()) + 8; }

/// Of an integer by its decimal digits.
void set(arb_t result, const cln::cl_I& value) {
  std::ostringstream text;
  cln::fprint(text, value);
  fmpz_t integer;
  fmpz_init(integer);
  fmpz_set_str(integer, text.str().c_str(), 10);
  arb_set_fmpz(result, integer);
  fmpz_clear(integer);
}

}  // namespace

struct Ball::Storage {
  Storage() { arb_init(value); }
  ~Storage() { arb_clear(value); }
  Storage(const Storage&) = delete;
  Storage& operator=(const Storage&) = delete;
  arb_t value;
};

template <class Operation>
Ball Ball::result(const Operation& operation) {
  auto storage = std::make_shared<Storage>();
  operation(storage->value);
  return Ball(std::move(storage));
}

bool Ball::available() { return true; }

Ball::Ball(int value) : Ball(result([value](arb_t z) { arb_set_si(z, value); })) {}

Ball Ball::from_double(double value) {
  return result([value](arb_t z) { arb_set_d(z, value); });
}

Ball Ball::of_number(const Number& number) {
  Ball sum;
  for (int k = 0; k < 4; ++k) {  // of 1, √2, √3, √6
    if (number.part(k) == 0) continue;
    const auto part = [&](arb_t z) {
      Storage denominator;
      set(z, cln::numerator(number.part(k)));
      set(denominator.value, cln::denominator(number.part(k)));
      arb_div(z, z, denominator.value, bits());
    };
    const int under_root[] = {1, 2, 3, 6};
    sum = sum + result(part) * sqrt(Ball(under_root[k]));
  }
  return sum;
}

Ball Ball::pi() {
  return result([](arb_t z) { arb_const_pi(z, bits()); });
}

Ball Ball::operator-() const {
  return result([this](arb_t z) { arb_neg(z, storage_->value); });
}
Ball operator+(const Ball& a, const Ball& b) {
  return Ball::result([&](arb_t z) { arb_add(z, a.storage_->value, b.storage_->value, bits()); });
}
Ball operator-(const Ball& a, const Ball& b) {
  return Ball::result([&](arb_t z) { arb_sub(z, a.storage_->value, b.storage_->value, bits()); });
}
Ball operator*(const Ball& a, const Ball& b) {
  return Ball::result([&](arb_t z) { arb_mul(z, a.storage_->value, b.storage_->value, bits()); });
}
Ball operator/(const Ball& a, const Ball& b) {
  return Ball::result([&](arb_t z) { arb_div(z, a.storage_->value, b.storage_->value, bits()); });
}
Ball sin(const Ball& x) {
  return Ball::result([&](arb_t z) { arb_sin(z, x.storage_->value, bits()); });
}
Ball cos(const Ball& x) {
  return Ball::result([&](arb_t z) { arb_cos(z, x.storage_->value, bits()); });
}
Ball sqrt(const Ball& x) {
  return Ball::result([&](arb_t z) { arb_sqrt(z, x.storage_->value, bits()); });
}
Ball exp(const Ball& x) {
  return Ball::result([&](arb_t z) { arb_exp(z, x.storage_->value, bits()); });
}
Ball log(const Ball& x) {
  return Ball::result([&](arb_t z) { arb_log(z, x.storage_->value, bits()); });
}

Ball atan2(const Ball& y, const Ball& x) {
  return Ball::result([&](arb_t z) { arb_atan2(z, y.storage_->value, x.storage_->value, bits()); });
}
Ball abs(const Ball& x) {
  return Ball::result([&](arb_t z) { arb_abs(z, x.storage_->value); });
}
Ball sign(const Ball& x) {
  if (arb_is_zero(x.storage_->value)) return Ball(0);
  return select(x, Ball(1), Ball(-1));
}
Ball maximum(const Ball& a, const Ball& b) { return select(a - b, a, b); }
Ball select(const Ball& condition, const Ball& a, const Ball& b) {
  if (arb_is_nonnegative(condition.storage_->value)) return a;
  if (arb_is_negative(condition.storage_->value)) return b;
  return Ball::result([&](arb_t z) { arb_union(z, a.storage_->value, b.storage_->value, bits()); });
}

double Ball::largest() const {
  mag_t size;
  mag_init(size);
  arb_get_mag(size, storage_->value);
  const double rounded_up = mag_get_d(size);
  mag_clear(size);
  return rounded_up;
}

double Ball::radius() const { return mag_get_d(arb_radref(storage_->value)); }

}  // namespace torsor

#else

namespace torsor {
namespace {

[[noreturn]] void absent() {
  throw Error("this torsor was built without ball arithmetic: install libflint-arb-dev and configure again");
}

}  // namespace

struct Ball::Storage {};

bool Ball::available() { return false; }
Ball::Ball(int) { absent(); }
Ball Ball::from_double(double) { absent(); }
Ball Ball::of_number(const Number&) { absent(); }
Ball Ball::pi() { absent(); }
Ball Ball::operator-() const { absent(); }
Ball operator+(const Ball&, const Ball&) { absent(); }
Ball operator-(const Ball&, const Ball&) { absent(); }
Ball operator*(const Ball&, const Ball&) { absent(); }
Ball operator/(const Ball&, const Ball&) { absent(); }
Ball sin(const Ball&) { absent(); }
Ball cos(const Ball&) { absent(); }
Ball sqrt(const Ball&) { absent(); }
Ball exp(const Ball&) { absent(); }
Ball log(const Ball&) { absent(); }
Ball atan2(const Ball&, const Ball&) { absent(); }
Ball abs(const Ball&) { absent(); }
Ball sign(const Ball&) { absent(); }
Ball maximum(const Ball&, const Ball&) { absent(); }
Ball select(const Ball&, const Ball&, const Ball&) { absent(); }
double Ball::largest() const { absent(); }
double Ball::radius() const { absent(); }

}  // namespace torsor

#endif
