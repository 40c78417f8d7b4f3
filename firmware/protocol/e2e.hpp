#pragma once

/// End-to-end protection of the frames that carry life: AUTOSAR E2E Profile 22, a CRC-8 and a 4-bit
/// counter in the frame, and data ids that are not sent. On 8 bytes CRC-8H2F finds every error of
/// up to 3 bits.
#include "firmware/protocol/e2e/checker.hpp"
#include "firmware/protocol/e2e/protector.hpp"
