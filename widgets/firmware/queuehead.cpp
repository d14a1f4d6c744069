// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/queuehead.h"

#include "widgets/common/captioned.h"
#include "widgets/common/filechoice.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/wraplayout.h"
#include "widgets/firmware/queuerecipe.h"
#include "widgets/service/recipetext.h"

#include <QHBoxLayout>
#include <QLabel>

namespace mb {
namespace {

constexpr int ordersBesideFrom = 640; ///< units

} // namespace

QueueHead::QueueHead(const ThemeSource &theme, QWidget *parent)
    : TurningRow(theme, ordersBesideFrom, parent)
    , m_theme(theme)
{
    const Theme &now = theme.theme();
    parts().setContentsMargins(now.u(16), now.u(10), now.u(16), now.u(10));
    auto *row = new QHBoxLayout;
    row->setSpacing(now.u(16));
    parts().addLayout(row, 1);
    m_name = addCaptioned(theme, tr("recipe"), TextRole::Emphasis, *row, 5, this);
    m_image = addCaptioned(theme, tr("image"), TextRole::Body, *row, 7, this);
    m_parameters = addCaptioned(theme, tr("parameters"), TextRole::Body, *row, 4, this);
    m_number = addCaptioned(theme, tr("number rule"), TextRole::Body, *row, 3, this);
    auto *image = new CommandButton(m_theme, Symbol::Folder, tr("Open image…"), this);
    auto *recipe = new CommandButton(m_theme, Symbol::Open, tr("Open recipe…"), this);
    auto *orders = new WrapLayout;
    orders->setSpacing(now.u(8));
    orders->addWidget(m_openImage = image);
    orders->addWidget(m_openRecipe = recipe);
    orders->addWidget(m_edit = new IconButton(m_theme, Symbol::Edit, tr("Write a recipe"), this));
    parts().addLayout(orders);
    connect(static_cast<IconButton *>(m_edit), &QToolButton::clicked, this, &QueueHead::editWanted);
    connect(image, &QPushButton::clicked, this, &QueueHead::askImage);
    connect(recipe, &QPushButton::clicked, this, &QueueHead::askRecipe);
    connect(this, &TurningRow::arranged, this,
        [this](bool turned) { parts().setSpacing(m_theme.theme().u(turned ? 6 : 16)); });
}

void QueueHead::show(const QueueRecipe &recipe)
{
    const service::RecipeMatter *matter = recipe.matter().get();
    m_name->setText(matter ? recipeName(matter) : tr("none yet"));
    m_image->setText(imageText(matter));
    m_parameters->setText(parameterText(matter));
    m_number->setText(numberText(matter));
}

void QueueHead::setChoosing(bool on)
{
    m_openImage->setEnabled(on);
    m_openRecipe->setEnabled(on);
    m_edit->setEnabled(on);
}

void QueueHead::askImage()
{
    askForFile(*this, tr("Open a firmware image"), tr("Intel HEX (*.hex *.ihex);;All files (*)"), {},
        [this](const QString &path) { Q_EMIT imageChosen(path); });
}

void QueueHead::askRecipe()
{
    askForFile(*this, tr("Open recipe"), tr("Recipes (*.json);;All files (*)"), {},
        [this](const QString &path) { Q_EMIT recipeChosen(path); });
}

} // namespace mb
