const kCounters = 16;
const kMaxDelta = 3;

function crc8h2f(bytes) {
  let crc = 0xff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) {
      crc = crc & 0x80 ? ((crc << 1) ^ 0x2f) & 0xff : crc << 1;
    }
  }
  return crc ^ 0xff;
}

function dataId(list, node, counter) {
  const base = ((list << 7) | node) & 0xff;
  return base ^ ((counter ^ (counter << 1)) << (1 + (list >> 1)));
}

function counterOf(frame, data) {
  return data[frame.integrity.crcByte + 1] & 0x0f;
}

function hasItsCrc(frame, node, data) {
  const { crcByte, idList } = frame.integrity;
  const covered = Array.from(data).filter((_, i) => i !== crcByte);
  covered.push(dataId(idList, node, counterOf(frame, data)));
  return data[crcByte] === crc8h2f(covered);
}

function rawOf(signal, data) {
  let raw = 0;
  for (let i = signal.bits - 1; i >= 0; --i) {
    const bit = signal.startBit + i;
    raw = 2 * raw + ((data[bit >> 3] >> (bit & 7)) & 1);
  }
  return raw;
}

function headerSignals(frame) {
  const signals = [];
  if (frame.integrity) {
    const startBit = 8 * frame.integrity.crcByte;
    signals.push({ startBit, bits: 8 }, { startBit: startBit + 8, bits: 4 });
  }
  if (frame.pageSignal) {
    signals.push(frame.pageSignal);
  }
  return signals;
}

function hasReservedBit(frame, message, data) {
  const rest = Uint8Array.from(data);
  for (const signal of [...headerSignals(frame), ...message.signals]) {
    for (let bit = signal.startBit; bit < signal.startBit + signal.bits; ++bit) {
      rest[bit >> 3] &= ~(1 << (bit & 7));
    }
  }
  return rest.some((byte) => byte !== 0);
}

function messageOf(frame, data) {
  if (!frame.pageSignal) {
    return frame.messages[0];
  }
  const page = rawOf(frame.pageSignal, data);
  return frame.messages.find((message) => message.page === page);
}

function frameOf(id) {
  const node = id & 0x7f;
  const frame = plan.find((candidate) => candidate.baseId === id - node);
  return frame && node !== 0 ? { frame, node } : null;
}

function readSignals(message, data, result) {
  for (const signal of message.signals) {
    const raw = rawOf(signal, data);
    const label = signal.values?.[raw];
    if (signal.closed && label === undefined) {
      return 'reserved_value';
    }
    result.signals[signal.name] = raw * signal.factor;
    if (label !== undefined) {
      result.labels[signal.name] = label;
    }
  }
  return null;
}

function errorOf(frame, node, data, result) {
  if (data.length !== frame.length) {
    return 'wrong_length';
  }
  if (frame.integrity && !hasItsCrc(frame, node, data)) {
    return 'wrong_crc';
  }
  const message = messageOf(frame, data);
  if (!message) {
    return 'unknown_page';
  }
  result.page = frame.pageSignal ? message.name : null;
  if (hasReservedBit(frame, message, data)) {
    return 'reserved_bit';
  }
  return readSignals(message, data, result);
}

/**
 * What a frame with this 11-bit identifier and these bytes (an array or Uint8Array) says, or null
 * where it is none of the plan.
 *
 * `signals` are physical values by name, in the units of the plan; `labels` the names of those values
 * that have one. `error` is null, or why the frame must not be used, and then both are empty:
 * 'wrong_length', 'wrong_crc', 'unknown_page', 'reserved_bit' or 'reserved_value'.
 */
export function decode(id, data) {
  const found = frameOf(id);
  if (!found) {
    return null;
  }
  const { frame, node } = found;
  const result = { node, name: frame.name, page: null, signals: {}, labels: {}, error: null };
  result.error = errorOf(frame, node, data, result);
  if (result.error) {
    result.signals = {};
    result.labels = {};
  }
  return result;
}

/**
 * Decodes the frames of a bus and also reports by `status` whether they follow each other, as AUTOSAR
 * E2E Profile 22 has it: 'initial', 'ok' and 'ok_some_lost' may be used; 'repeated',
 * 'wrong_sequence', 'wrong_crc' and 'wrong_length' may not; 'unprotected' has no counter.
 */
export class Receiver {
  #counters = new Map();

  receive(id, data) {
    const result = decode(id, data);
    return result && { ...result, status: this.#statusOf(id, data, result.error) };
  }

  #statusOf(id, data, error) {
    if (error === 'wrong_length' || error === 'wrong_crc') {
      return error;
    }
    const { frame } = frameOf(id);
    if (!frame.integrity) {
      return 'unprotected';
    }
    const counter = counterOf(frame, data);
    const last = this.#counters.get(id);
    this.#counters.set(id, counter);
    if (last === undefined) {
      return 'initial';
    }
    const delta = (counter - last + kCounters) % kCounters;
    if (delta === 0) {
      return 'repeated';
    }
    if (delta > kMaxDelta) {
      return 'wrong_sequence';
    }
    return delta === 1 ? 'ok' : 'ok_some_lost';
  }
}
