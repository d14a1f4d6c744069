// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/start/guidestrip.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/spoken.h"
#include "widgets/common/stateglyph.h"
#include "widgets/common/turningbox.h"
#include "widgets/common/wraplayout.h"

namespace mb {
namespace {

constexpr int roomBeside = 640; ///< of the strip, for its buttons beside its words
constexpr int leastSteps = 160;

} // namespace

GuideStrip::GuideStrip(Shows shows, Guide &guide, const ThemeSource &theme, QWidget *parent)
    : QFrame(parent)
    , m_shows(shows)
    , m_guide(guide)
    , m_theme(theme)
{
    setObjectName(shows == Shows::Offers ? QStringLiteral("guideOffer") : QStringLiteral("guide"));
    setAccessibleName(tr("Guide"));
    setStyleProperty(*this, "banner", QStringLiteral("info"));
    build();
    connect(&guide, &Guide::changed, this, &GuideStrip::follow);
    follow();
}

void GuideStrip::build()
{
    const Theme &theme = m_theme.theme();
    auto *parts = new TurningBox(m_theme, roomBeside, this);
    parts->setContentsMargins(theme.u(12), theme.u(6), theme.u(12), theme.u(6));
    parts->setSpacing(theme.u(12));
    auto *words = new QWidget(this);
    auto *grid = layoutIn<QGridLayout>(words);
    grid->setHorizontalSpacing(theme.u(12));
    grid->setVerticalSpacing(theme.u(2));
    m_glyph = new StateGlyph(m_theme, GlyphState::Busy, words);
    m_title = textLabel({}, TextRole::Emphasis, Tone::Text, words);
    m_steps = new ElidedLabel({}, words);
    m_steps->setObjectName(QStringLiteral("guideSteps"));
    m_steps->setMinimumWidth(theme.u(leastSteps));
    setTone(*m_steps, Tone::Dim);
    m_words = textLabel({}, TextRole::Body, Tone::Text, words);
    m_words->setObjectName(QStringLiteral("guideWords"));
    m_words->setWordWrap(true);
    auto *head = new WrapLayout; // the steps beside the title, or below it
    head->setSpacing(theme.u(12));
    head->setLineSpacing(theme.u(2));
    head->addWidget(m_title);
    head->addWidget(m_steps);
    head->setStretched(m_steps);
    grid->addWidget(m_glyph, 0, 0, Qt::AlignTop);
    grid->addLayout(head, 0, 1);
    grid->addWidget(m_words, 1, 1);
    grid->setColumnStretch(1, 1);
    parts->addWidget(words, 1);
    parts->addWidget(buildButtons());
}

QWidget *GuideStrip::buildButtons()
{
    auto *buttons = new QWidget(this);
    auto *row = new WrapLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    m_act = new CommandButton(m_theme, tr("Show me where"), buttons);
    m_act->setTextVariants({tr("Show me where"), tr("Begin")});
    m_leave = new CommandButton(m_theme, tr("Dismiss"), buttons);
    m_leave->setTextVariants({tr("Dismiss"), tr("Not now"), tr("Close")});
    row->addWidget(m_act);
    row->addWidget(m_leave);
    connect(m_act, &QPushButton::clicked, this, &GuideStrip::act);
    connect(m_leave, &QPushButton::clicked, this, &GuideStrip::leave);
    return buttons;
}

void GuideStrip::offer(const Story *story)
{
    if (std::exchange(m_offer, story) == story)
        return;
    follow();
}

void GuideStrip::follow()
{
    const bool playing = m_shows == Shows::Steps && m_guide.story();
    const bool offering = m_shows == Shows::Offers && m_offer && !m_guide.story();
    setVisible(playing || offering);
    if (playing)
        showSteps();
    else if (offering)
        showOffer();
    m_act->setPrimary(!playing);
}

void GuideStrip::showOffer()
{
    m_glyph->setState(GlyphState::Waiting);
    m_title->setText(storyText(*m_offer, m_offer->title));
    m_steps->hide(); // an empty line would stand below the title
    setWords(storyText(*m_offer, m_offer->words) + QLatin1Char(' ')
        + tr("Simulated: nothing real moves. A guide says each step and waits until it has happened."));
    m_act->show();
    setOrders(tr("Begin"), tr("Not now"));
}

void GuideStrip::showSteps()
{
    const Story &story = *m_guide.story();
    const bool done = m_guide.isDone();
    m_glyph->setState(done ? GlyphState::Done : GlyphState::Busy);
    m_title->setText(storyText(story, story.title));
    QStringList steps;
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        const QString name = storyText(story, story.steps[i].name);
        if (i < m_guide.step())
            steps += tr("%1 done").arg(name);
        else if (i == m_guide.step())
            steps += tr("%1. %2").arg(i + 1).arg(name);
        else
            steps += name;
    }
    m_steps->show();
    m_steps->setText(steps.join(QStringLiteral("  ·  ")));
    QString words;
    if (done) {
        words = tr("Done.");
    } else if (!m_guide.device()) {
        words = tr("The simulated bench is opened; the unit answers in a moment.");
    } else {
        const StoryStep &step = story.steps[m_guide.step()];
        words = storyText(story, step.words, m_keyOf ? m_keyOf(step) : QString::fromLatin1(step.key));
    }
    if (const QString result = m_guide.result(); !result.isEmpty())
        words += QLatin1Char(' ') + tr("Measured: %1.").arg(result);
    setWords(words);
    m_act->setVisible(!done);
    setOrders(tr("Show me where"), done ? tr("Close") : tr("Dismiss"));
}

void GuideStrip::setOrders(const QString &act, const QString &leave)
{
    m_act->setText(act);
    m_act->setAccessibleName(act);
    m_leave->setText(leave);
    m_leave->setAccessibleName(leave);
}

void GuideStrip::setWords(const QString &words)
{
    m_words->setText(words);
    setSpoken(*this, accessibleName(), words);
}

void GuideStrip::setKeys(KeyOf keyOf)
{
    m_keyOf = std::move(keyOf);
    follow();
}

bool GuideStrip::event(QEvent *event)
{
    if (event->type() == keysChanged())
        follow();
    return QFrame::event(event);
}

void GuideStrip::act()
{
    if (m_shows == Shows::Steps && m_guide.story() && !m_guide.isDone())
        Q_EMIT placeWanted(m_guide.story()->steps[m_guide.step()].place);
    else if (m_offer)
        Q_EMIT wanted(*m_offer);
}

void GuideStrip::leave()
{
    if (m_shows == Shows::Steps) {
        m_guide.end();
        return;
    }
    m_offer = nullptr;
    follow();
    Q_EMIT refused();
}

} // namespace mb
