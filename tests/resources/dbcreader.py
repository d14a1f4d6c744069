# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads DBC files: messages, signals, simple multiplexing, value tables. Written from the format's public description,
without a look at what writes ours."""
import re

EXTENDED = 1 << 31
MESSAGE = re.compile(r"BO_ (\d+) (\w+) ?: (\d+) (\w+)$")
SIGNAL = re.compile(r'SG_ (\w+) (M|m\d+)? ?: (\d+)\|(\d+)@([01])([+-]) \(([^,]+),([^)]+)\) \[([^|]+)\|([^\]]+)\] "([^"]*)" (\S.*)$')
VALUES = re.compile(r"VAL_ (\d+) (\w+) (.*) ;$")
CHOICE = re.compile(r'(\d+) "([^"]*)"')


class Signal:
    def __init__(self, match):
        self.name, mux, start, length, order, sign, factor, offset, _, _, self.unit, _ = match.groups()
        self.start, self.length, self.little, self.signed = int(start), int(length), order == "1", sign == "-"
        self.factor, self.offset = float(factor), float(offset)
        self.selects = mux == "M"
        self.selected_by = int(mux[1:]) if mux and mux != "M" else None
        self.choices = {}

    def bits(self):
        """Places in the frame, the lowest bit first: (byte, bit in it)."""
        if self.little:
            return [divmod(self.start + i, 8) for i in range(self.length)]
        places, byte, bit = [], self.start // 8, self.start % 8  # from the highest bit down
        for _ in range(self.length):
            places.append((byte, bit))
            byte, bit = (byte + 1, 7) if bit == 0 else (byte, bit - 1)
        return places[::-1]

    def raw(self, data):
        """Nothing when the frame is too short to have it."""
        places = self.bits()
        if max(byte for byte, _ in places) >= len(data):
            return None
        value = sum((data[byte] >> bit & 1) << i for i, (byte, bit) in enumerate(places))
        return value - (1 << self.length) if self.signed and value >> (self.length - 1) else value


class Message:
    def __init__(self, match):
        identifier, self.name, self.size, self.sender = int(match[1]), match[2], int(match[3]), match[4]
        self.id, self.extended = identifier & ~EXTENDED, bool(identifier & EXTENDED)
        self.signals = []

    def decode(self, data):
        """{name: value}"""
        selector = next((signal.raw(data) for signal in self.signals if signal.selects), None)
        found = {}
        for signal in self.signals:
            raw = signal.raw(data)
            if raw is not None and signal.selected_by in (None, selector):
                found[signal.name] = raw * signal.factor + signal.offset
        return found


def read(path):
    """{(identifier, is it extended): message}"""
    messages, by_id, message = {}, {}, None
    for line in path.read_text(encoding="ascii").splitlines():
        line = line.strip()
        if match := MESSAGE.match(line):
            message = Message(match)
            key = (message.id, message.extended)
            assert key not in messages, f"two messages under {match[1]}"
            messages[key] = by_id[match[1]] = message
        elif match := SIGNAL.match(line):
            message.signals.append(Signal(match))
        elif line.startswith(("BO_ ", "SG_ ")):
            raise AssertionError(f"not understood: {line}")
        elif match := VALUES.match(line):
            signal = next(s for s in by_id[match[1]].signals if s.name == match[2])
            signal.choices = {int(value): word for value, word in CHOICE.findall(match[3])}
    return messages
