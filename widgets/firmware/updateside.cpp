// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/updateside.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/firmware/pagemap.h"
#include "widgets/firmware/stepspanel.h"

namespace mb {

UpdateSide::UpdateSide(const ThemeSource &theme, QWidget *parent)
    : QScrollArea(parent)
    , m_theme(theme)
{
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *panel = new QWidget(this);
    setWidget(panel);
    auto *column = layoutIn<QVBoxLayout>(panel, theme.theme().u(8));
    column->addWidget(buildSafety(panel));
    m_column = new QVBoxLayout;
    m_column->setContentsMargins(theme.theme().u(16), 0, theme.theme().u(16), theme.theme().u(12));
    m_column->setSpacing(theme.theme().u(8));
    m_steps = new StepsPanel(m_theme, panel);
    m_column->addWidget(m_steps);
    m_column->addWidget(m_pages = buildPages(panel));
    m_notes = textLabel({}, TextRole::Caption, Tone::Dim, panel);
    m_notes->setWordWrap(true);
    m_column->addWidget(m_notes);
    m_column->addStretch();
    column->addLayout(m_column, 1);
}

QFrame *UpdateSide::buildSafety(QWidget *parent)
{
    const Theme &theme = m_theme.theme();
    m_safety = new QFrame(parent);
    auto *words = layoutIn<QVBoxLayout>(m_safety, theme.u(2), {theme.u(16), theme.u(12), theme.u(16), theme.u(12)});
    m_title = textLabel({}, TextRole::Emphasis, Tone::Ok, m_safety);
    m_title->setWordWrap(true);
    m_text = textLabel({}, TextRole::Caption, Tone::Dim, m_safety);
    m_text->setWordWrap(true);
    words->addWidget(m_title);
    words->addWidget(m_text);
    return m_safety;
}

QWidget *UpdateSide::buildPages(QWidget *parent)
{
    auto *area = new QWidget(parent);
    auto *column = layoutIn<QVBoxLayout>(area, m_theme.theme().u(8));
    column->addWidget(new SectionLabel(tr("Flash pages"), area));
    m_map = new PageMap(m_theme, area);
    column->addWidget(m_map);
    auto *legend = textLabel(tr("In the order they are written. Green: written. Amber edge: sent again. Dashed: not in "
                                "the image. Red: must not be cut."),
        TextRole::Caption, Tone::Dim, area);
    legend->setWordWrap(true);
    column->addWidget(legend);
    return area;
}

void UpdateSide::showSafety(Safety safety, const QString &place, const UpdateWords &words)
{
    const bool critical = safety == Safety::MustNotCut;
    const bool turns = safety == Safety::Turns || safety == Safety::WaitsToTurn;
    setStyleProperty(*m_safety, "banner",
        critical    ? QStringLiteral("danger")
            : turns ? QStringLiteral("caution")
                    : QStringLiteral("ok"));
    const QString word = critical || turns ? tr("Do not unplug") : tr("Safe to unplug");
    m_title->setText(safety == Safety::Nothing && place.isEmpty() ? tr("Nothing is written now")
                                                                  : word + QStringLiteral(": ") + place);
    setTone(*m_title, critical ? Tone::Danger : turns ? Tone::Caution : Tone::Ok);
    m_text->setVisible(safety != Safety::Nothing);
    m_text->setText(safety == Safety::WaitsToTurn ? tr("The motor turns as soon as Arm in the header is held.")
            : turns                               ? tr("The self-test turns the motor.")
                    : tableText(critical && !words.fatalCut.empty() ? words.fatalCut : words.cut));
}

void UpdateSide::placeSafety(QVBoxLayout *column)
{
    if (column)
        column->addWidget(m_safety);
    else
        static_cast<QVBoxLayout *>(widget()->layout())->insertWidget(0, m_safety);
}

void UpdateSide::setNotes(const QString &notes)
{
    m_notes->setText(notes);
}

void UpdateSide::add(QWidget *part)
{
    m_column->insertWidget(m_column->indexOf(m_steps) + 1, part);
}

} // namespace mb
