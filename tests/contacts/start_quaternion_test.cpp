// SPDX-License-Identifier: GPL-3.0-or-later
// What a motion with contacts starts from is an attitude, whatever norm its quaternion is given.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>

#include "generated/billiard.hpp"
#include "torsor/runtime/contacts/contact_exchange.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"
#include "torsor/runtime/contacts/moreau_jean.hpp"

namespace torsor::contact_start_quaternion_test {
namespace {

using namespace runtime;
using Ball = MechanismWithContacts<billiard::Mechanism<double>>;

/// It slides over the cloth, and turns as it does.
Ball::State start(const Ball& ball, double norm) {
  Ball::State y = ball.initial();
  const std::array<double, 4> attitude{0.5, -0.5, 0.5, 0.5};
  const auto first = static_cast<std::size_t>(billiard::Mechanism<double>::quaternions[0]);
  for (std::size_t k = 0; k < 4; ++k) y[first + k] = norm * attitude[k];
  return y;
}

TEST(ContactStartQuaternion, GivesTheMotionOfItsAttitude) {
  const Ball ball;
  Ball::State unit = start(ball, 1), other = start(ball, 4);  // all roundings are those of powers of two
  ASSERT_TRUE(integrate_contacts(ball, unit, 0.0, 0.1));
  ASSERT_TRUE(integrate_contacts(ball, other, 0.0, 0.1));
  EXPECT_EQ(other, unit);
  unit = start(ball, 1), other = start(ball, 4);
  ASSERT_EQ(step_contacts(ball, unit, 0.0, 0.1, {.count = 10}), ContactStatus::reached_end);
  ASSERT_EQ(step_contacts(ball, other, 0.0, 0.1, {.count = 10}), ContactStatus::reached_end);
  EXPECT_EQ(other, unit);
}

TEST(ContactStartQuaternion, OfZerosBeginsNothing) {
  const Ball ball;
  Ball::State y = start(ball, 0);
  const ContactResult result = integrate_contacts(ball, y, 0.5, 1.0);
  EXPECT_EQ(result.status, ContactStatus::zero_quaternion) << describe(result.status);
  EXPECT_FALSE(result.contact.has_value());
  EXPECT_EQ(result.time, 0.5);
  EXPECT_EQ(y, start(ball, 0));
  EXPECT_EQ(step_contacts(ball, y, 0.5, 1.0, {.count = 10}), ContactStatus::zero_quaternion);
  EXPECT_EQ(y, start(ball, 0));
  const ContactMechanismOf<Ball> mechanism(ball);
  ContactExchange exchange(mechanism, {}, 1e-10);
  EXPECT_FALSE(exchange.start(0.5, y));
  EXPECT_EQ(exchange.result().status, ContactStatus::zero_quaternion);
}

}  // namespace
}  // namespace torsor::contact_start_quaternion_test
