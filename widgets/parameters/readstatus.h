// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/stateglyph.h"
#include "widgets/parameters/parameterfilter.h"

#include "model/snapshot.h"

class QLabel;
class QProgressBar;

namespace mb {

/// A device has an operation, and it has not ended.
[[nodiscard]] bool isUnderWay(const OperationView *operation);

/// How well the values are known: "all 55 read in 0.07 s", "Reading 23 of 55" with a bar, "1 of 55 gave no answer".
class ReadStatus : public QWidget {
    Q_OBJECT
public:
    ReadStatus(const ThemeSource &theme, QWidget *parent);
    void showDevice(const DeviceView &device, const OperationView *operation, const ParameterCounts &counts);
    void showFile(const QString &name, const QString &family);

private:
    void say(GlyphState glyph, const QString &text);
    [[nodiscard]] bool showReading(const OperationView *operation);
    [[nodiscard]] QString outcome(const DeviceView &device, const OperationView *operation,
        const ParameterCounts &counts, GlyphState &glyph) const;

    StateGlyph *m_glyph = nullptr;
    QLabel *m_text = nullptr;
    QProgressBar *m_bar = nullptr;
};

} // namespace mb
