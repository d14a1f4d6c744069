// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/tuningsteps.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/stateglyph.h"
#include "widgets/control/wrappedlabel.h"

namespace mb {
namespace {

constexpr int mostLines = 9;

bool isGood(tuning::TuneResult result)
{
    return result == tuning::TuneResult::Kept || result == tuning::TuneResult::Proposed;
}

} // namespace

QString resultText(tuning::TuneResult result)
{
    switch (result) {
    case tuning::TuneResult::Kept: return TuningSteps::tr("Kept");
    case tuning::TuneResult::Proposed: return TuningSteps::tr("Proposed, nothing written");
    case tuning::TuneResult::RolledBack: return TuningSteps::tr("Rolled back");
    case tuning::TuneResult::Refused: return TuningSteps::tr("Refused");
    case tuning::TuneResult::Stopped: return TuningSteps::tr("Stopped");
    }
    return {};
}

TuningSteps::TuningSteps(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    const Theme &look = theme.theme();
    auto *column = layoutIn<QVBoxLayout>(this, look.u(8));
    column->addWidget(new SectionLabel(tr("What happens"), this));
    auto *row = new QHBoxLayout;
    m_glyph = new StateGlyph(theme, GlyphState::Waiting, this);
    m_head = wrappedLabel({}, TextRole::Emphasis, Tone::Text, this);
    row->addWidget(m_glyph, 0, Qt::AlignTop);
    row->addWidget(m_head, 1);
    column->addLayout(row);
    m_words = wrappedLabel({}, TextRole::Body, Tone::Dim, this);
    column->addWidget(m_words);
    m_lines = new QVBoxLayout;
    m_lines->setSpacing(look.u(8));
    column->addLayout(m_lines);
    column->addStretch(1);
    show(nullptr, nullptr);
}

void TuningSteps::show(const OperationView *running, const tuning::TuneReport *report)
{
    QStringList lines;
    if (running) {
        m_glyph->setState(GlyphState::Moving);
        m_head->setText(tr("Working: the motor turns"));
        m_words->setText(tr("STOP ends it at any moment; what was changed is put back."));
        for (const LogLine &line : running->status.log)
            lines << messageText(line.text);
        while (lines.size() > mostLines)
            lines.removeFirst();
    } else if (report) {
        m_glyph->setState(isGood(report->result) ? GlyphState::Done : GlyphState::Warning);
        m_head->setText(resultText(report->result));
        m_words->setText(messageText(report->evidence));
    } else {
        m_glyph->setState(GlyphState::Waiting);
        m_head->setText(tr("Nothing has moved yet"));
        m_words->clear();
    }
    m_words->setVisible(!m_words->text().isEmpty());
    if (!running && !(report && report->result == tuning::TuneResult::Kept))
        lines << tr("1  Identify: pushes with a part of the duty, both ways. No gain is changed.")
              << tr("2  Choose what it is to be like. The plots show what each set would do.")
              << tr("3  Write and prove: the gains are written, two steps in each direction are measured.")
              << tr("4  They stay if they do what was predicted; else everything is put back and the reason said.");
    say(std::move(lines));
}

void TuningSteps::say(QStringList lines)
{
    if (lines == m_said)
        return;
    m_said = std::move(lines);
    while (QLayoutItem *item = m_lines->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const QString &line : m_said)
        m_lines->addWidget(wrappedLabel(line, TextRole::Body, Tone::Text, this));
}

} // namespace mb
