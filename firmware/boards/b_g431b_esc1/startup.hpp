#pragma once

/// The entry of the device.
extern "C" void isr_reset();
