// What a log says of each node, by the JavaScript decoder that is made from the frame plan.
import { readFileSync } from 'node:fs';

const LINE = /^\((\d+)\.(\d{6})\) \S+ ([0-9A-F]{3})#([0-9A-F]*)$/;
const USABLE = ['initial', 'ok', 'ok_some_lost', 'unprotected'];
const COUNTED = {
  repeated: 'repeated',
  wrong_sequence: 'wrong_sequence',
  wrong_crc: 'damaged',
  wrong_length: 'damaged',
};

function emptyNode() {
  return { messages: {}, tendons: {}, bins: {}, wires: {}, advice: {}, counts: {}, damage: 0, emergencies: [] };
}

function keep(node, result, time_us) {
  const { signals, labels, name, page } = result;
  const message = { ...signals, ...labels, time_us };
  node.messages[page ?? name] = message;
  if (name === 'LifeStatus') {
    node.damage = Math.max(node.damage, signals.Damage);
  } else if (name === 'Emergency') {
    node.emergencies.push(labels.EmergencyCode);
  } else if (page === 'TendonDamage') {
    node.tendons[signals.Tendon] = message;
  } else if (page === 'WireHistory') {
    const wire = (node.wires[signals.WireTendon] ??= { counts: {} });
    wire.newest = signals;
    wire.counts[labels.WireEvent] = signals.WireCount;
  } else if (page === 'Advice') {
    node.advice[signals.AdviceTendon] = message;
  } else if (page === 'RainflowBin') {
    node.bins[`${signals.BinTendon} ${signals.BinRange} ${signals.BinMean}`] = signals;
  }
}

/** The nodes of the log up to a time, and its lines until then. */
export function decodedLog(file, { Receiver }, until_us = Infinity) {
  const receiver = new Receiver();
  const nodes = {};
  const lines = [];
  for (const line of readFileSync(file, 'utf8').split('\n').filter(Boolean)) {
    const [, seconds, fraction, id, hex] = LINE.exec(line);
    const time_us = Number(seconds) * 1e6 + Number(fraction);
    if (time_us >= until_us) {
      break;
    }
    lines.push(line);
    const result = receiver.receive(parseInt(id, 16), Buffer.from(hex, 'hex'));
    const node = (nodes[result.node] ??= emptyNode());
    const counts = (node.counts[result.name] ??= {
      good: 0,
      repeated: 0,
      wrong_sequence: 0,
      damaged: 0,
    });
    if (USABLE.includes(result.status)) {
      counts.good += 1;
      keep(node, result, time_us);
    } else {
      counts[COUNTED[result.status]] += 1;
    }
  }
  return { nodes, lines };
}
