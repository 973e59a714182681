/* SPDX-License-Identifier: MIT */
/* What happens before main on a Cortex-M: the table of vectors, the unit of floating point, memory. */
#include <stdint.h>

extern uint32_t data_begin[], data_end[], bss_begin[], bss_end[], stack_end[];
extern const uint32_t data_in_flash[];
int main(void);
void finish(int code);

void reset(void);
static void stop(void) { finish(70); } /* a fault */

/* The interrupt of the system's clock, where a program has one */
__attribute__((weak)) void tick(void) { stop(); }

typedef void (*Handler)(void);
/* 1: reset, 2 to 6: faults, 15: the system's clock */
__attribute__((section(".vectors"), used)) static const struct {
  uint32_t* stack;
  Handler handlers[15];
} vectors = {stack_end, {reset, stop, stop, stop, stop, stop, 0, 0, 0, 0, stop, stop, 0, stop, tick}};

/* Asks the debugger or QEMU (semihosting). */
static int ask(int operation, const void* argument) {
  register int r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}
void say(const char* text) { ask(0x04, text); }
void finish(int code) {
  const uint32_t reason[2] = {0x20026, (uint32_t)code}; /* the program ended */
  ask(0x20, reason);
  for (;;) {
  }
}

void reset(void) {
#if defined(__ARM_FP)
  volatile uint32_t* const access = (volatile uint32_t*)0xe000ed88; /* of coprocessors: CPACR */
  *access |= 0xfu << 20;
  __asm__ volatile("dsb\n\tisb");
#endif
  const uint32_t* from = data_in_flash;
  for (uint32_t* to = data_begin; to < data_end;) *to++ = *from++;
  for (uint32_t* to = bss_begin; to < bss_end;) *to++ = 0;
  finish(main());
}
