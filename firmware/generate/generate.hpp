#pragma once

#include <span>
#include <string>

#include "firmware/protocol/messages.hpp"

/// What others need to know of the frame plan, written from the schema. Host only.
namespace protocol::generate {

/// A DBC file with the exact identifiers of these nodes, each 1 .. 127 and there once. Names of
/// messages end in the node: LifeStatus_7.
///
/// Kept to what third-party readers agree on: one simple multiplexor in a message, before what it
/// selects; one line for each comment; no space in (factor,offset) and no exponents; attribute
/// values of word characters; GenMsgCycleTime on every cyclic frame.
std::string dbc(std::span<const Node> nodes);

/// A DBC file of one node without its id, for tools that mask identifiers with 0x780 and so read
/// frames of any node with it.
std::string dbc_template();

/// An ES module without dependencies for browsers and Node.js: decode(id, data), Receiver and plan.
std::string javascript();

/// The frame table of firmware/protocol/README.md in Markdown, with an end of line.
std::string table();

/// The table of services of firmware/protocol/README.md in Markdown, with an end of line.
std::string services();

}  // namespace protocol::generate
