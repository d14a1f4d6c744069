// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameterstore.h"
#include "widgets/common/stateglyph.h"
#include "widgets/parameters/stagededits.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QGridLayout;
class QPushButton;

namespace mb {

class IconButton;
class LogSlider;
class ResolutionMeter;

/// One gain: name, field, unit, state, revert; below a slider of one decade either way, the resolution, the raw value and
/// what it is in physical units. Bounds of a loop are the first line only. Edits go to the StagedEdits it was made for;
/// nothing is written from here.
class GainRow : public QWidget {
    Q_OBJECT
public:
    enum class Kind { Gain, Bound };

    GainRow(const ThemeSource &theme, Kind kind, StagedEdits &edits, ParameterIndex index, QWidget *parent);

    [[nodiscard]] ParameterIndex index() const { return m_index; }
    void setUnit(const QString &unit);
    /// "2.49e-3 duty/(rad/s)"; empty shows none.
    void setPhysical(const QString &text) { m_physical = text; }
    /// The newest of the device and of what is staged.
    void refresh(const ParameterStore::Entry &entry);
    void setReading(bool reading) { m_reading = reading; }
    /// What stands in the field, staged or in force; nothing while it is not legal or not known.
    [[nodiscard]] std::optional<double> number() const;
    void focusField();

protected:
    /// The wheel over the field that has the focus changes the gain by 2 %; nothing else of the mouse does.
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void multiply(double factor);
    void buildFirstLine(QGridLayout &grid);
    void buildSecondLine(QGridLayout &grid);
    void typed(const QString &text) { m_edits.type(m_index, text); }
    void chosen(double number);
    void showState(const ParameterStore::Entry &entry, const StagedEdit *edit);
    void showNumbers(std::optional<std::int64_t> raw, bool edited);
    [[nodiscard]] QString shortWord(GlyphState state) const;

    const ThemeSource &m_theme;
    Kind m_kind;
    StagedEdits &m_edits;
    ParameterIndex m_index;
    const Parameter &m_parameter;
    bool m_reading = false;
    bool m_sliding = false;
    int m_turned = 0; ///< eighths of a degree of the wheel that are not yet a step
    QString m_physical;
    QLineEdit *m_field = nullptr;
    QLabel *m_unit = nullptr;
    StateGlyph *m_glyph = nullptr;
    QLabel *m_word = nullptr;
    IconButton *m_revert = nullptr;
    LogSlider *m_slider = nullptr;
    ResolutionMeter *m_meter = nullptr;
    QWidget *m_detail = nullptr;
    QLabel *m_raw = nullptr;
    QLabel *m_fault = nullptr;
    QPushButton *m_use = nullptr; ///< after one more look
};

} // namespace mb
