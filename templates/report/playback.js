// SPDX-License-Identifier: MIT-0
// A motion that was recorded, with what its contacts did.
(() => {
"use strict";
const { Samples } = torsorReport;

/// Doubles, the lowest byte first, in base 64; `width` of them in each row.
function rows(text, width) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)), view = new DataView(bytes.buffer), result = [];
  for (let at = 0; width > 0 && at < bytes.length; at += 8 * width) {
    result.push(Float64Array.from({ length: width }, (_, i) => view.getFloat64(at + 8 * i, true)));
  }
  return result;
}

class Playback extends Samples {
  constructor(mechanism, recording) {
    super(mechanism, recording.interval);
    this.recorded = true;
    this.parameters = mechanism.defaultParameters();
    this.precomputed = mechanism.precompute(this.parameters);
    this.inputs = new Float64Array(mechanism.inputs.length);
    this.samples = rows(recording.states, recording.numbers);
    this.ofContacts = rows(recording.contactStates, recording.contactNumbers);
    this.start = this.samples[0];
    this.stopped = recording.status;
    this.contacts = [];
    let at = 0, row = 0;
    for (const each of recording.contacts) {
      this.contacts.push({ ...each, gap: each.normal ? at : -1, first: at + (each.normal ? 1 : 0), row });
      at += each.reactions.length + (each.normal ? 1 : 0);
      row += each.reactions.length;
    }
    this.changes = recording.regimes;
    this.events = recording.events.map(([time, kind, contact, lost, after]) => ({ time, kind, contact, lost, after }));
    this.eventCount = recording.eventCount;
  }

  extend() { return false; }
  reactions() { return []; }

  /// N and T of contact c at sample k.
  reactionsOf(c, k) {
    const { first, reactions } = this.contacts[c];
    return this.ofContacts[k].subarray(first, first + reactions.length);
  }

  /// A letter for each contact at sample k: o open (of friction in a joint free), c closed, s sticks, d slides.
  regimesAt(k) {
    let found = this.changes[0]?.[1] ?? "";
    for (const [from, letters] of this.changes) if (from <= k) found = letters;
    return found;
  }

  static regime(letter, contact) {
    return { o: contact.normal ? "«open»" : "«free»", c: "«closed»", s: "«sticks»", d: "«slides»" }[letter];
  }

  regimesInWords(letters) { return this.contacts.map((each, c) => `${each.name}: ${Playback.regime(letters[c], each)}`).join(", "); }

  eventInWords({ kind, contact, lost }) {
    const { name, normal } = this.contacts[contact];
    const opens = normal ? `«${name} opens»` : `«${name} is let go»`;
    const words = [`«impact of ${name}»`, opens, `«${name} begins to slide»`, `«${name} stops sliding»`, `«end of the bounces of ${name}»`][kind];
    return lost ? `${words}«, energy lost: »${Number(lost.toPrecision(4))} J` : words;
  }
}

torsorReport.Playback = Playback;
})();
