// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/start/storycard.h"

#include "widgets/common/iconbutton.h"
#include "widgets/start/storydrawing.h"

#include <QHBoxLayout>

namespace mb {

StoryCard::StoryCard(const Story &story, const ThemeSource &theme, QWidget *parent)
    : Card(theme, parent)
{
    setObjectName(QStringLiteral("story-%1").arg(QLatin1String(story.key.data(), static_cast<int>(story.key.size()))));
    setAccessibleName(storyText(story, story.title));
    setFlush(true);
    body().addWidget(new StoryDrawing(story.picture, storyText(story, story.caption), theme, this));
    body().addWidget(separatorLine(Qt::Horizontal, this));
    buildHead(story, theme);
}

void StoryCard::buildHead(const Story &story, const ThemeSource &theme)
{
    const int pad = theme.theme().u(12);
    auto *column = new QVBoxLayout;
    column->setContentsMargins(pad, pad, pad, pad);
    column->setSpacing(theme.theme().u(4));
    auto *head = new QHBoxLayout;
    auto *motor = new ElidedLabel(storyMotor(story), this);
    setTextRole(*motor, TextRole::Title);
    head->addWidget(motor, 1);
    head->addWidget(textLabel(tr("about %n min", nullptr, story.minutes), TextRole::Caption, Tone::Dim, this));
    column->addLayout(head);
    auto *parts = textLabel(storyParts(story), TextRole::Caption, Tone::Dim, this);
    parts->setWordWrap(true);
    column->addWidget(parts);
    column->addSpacing(theme.theme().u(6));
    auto *words = textLabel(storyText(story, story.words), TextRole::Body, Tone::Text, this);
    words->setWordWrap(true);
    column->addWidget(words);
    column->addStretch(1);
    column->addSpacing(theme.theme().u(8));
    m_try = new CommandButton(theme, Symbol::Play, tr("Try it"), this);
    m_try->setAccessibleName(tr("Try it: %1").arg(storyText(story, story.title)));
    column->addWidget(m_try);
    body().addLayout(column, 1);
    connect(m_try, &QPushButton::clicked, this, [this, &story] { Q_EMIT wanted(story); });
}

void StoryCard::setPrimary(bool primary)
{
    m_try->setPrimary(primary);
}

} // namespace mb
