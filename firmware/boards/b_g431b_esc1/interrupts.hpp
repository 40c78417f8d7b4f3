#pragma once

/// Handlers in the vector table, beside isr_fault().
extern "C" {
void isr_nmi();      ///< a damaged double word in a guarded read, or the end
void isr_control();  ///< ADC1 and ADC2: one period of the control loop
void isr_settle();   ///< PendSV: counts cycles below the control loop
}
