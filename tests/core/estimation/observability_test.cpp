#include "core/estimation/observability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/estimation/design.h"

namespace nineline::estimation {
namespace {

using testing::ElementsAre;

/// Information of readings with these rows, each of uncertainty 0.01.
MatrixXd informationOf(const MatrixXd& rows) { return 1e4 * rows.transpose() * rows; }

std::vector<ParameterChunk> single(Index count) {
  std::vector<ParameterChunk> chunks;
  for (Index k = 0; k < count; ++k) chunks.push_back({{k}, {}});
  return chunks;
}

TEST(TellApart, NamesTheFirstOfTwoThatShowTheSame) {
  MatrixXd rows(3, 3);
  rows << 1, 2, 0,  //
      0, 0, 1,      //
      2, 4, 1;      // the second column is twice the first
  const auto tellings = tellApart(informationOf(rows), VectorXd::Ones(3), single(3));
  EXPECT_TRUE(tellings[0].told);
  EXPECT_FALSE(tellings[1].told);
  EXPECT_TRUE(tellings[1].has_influence);
  EXPECT_THAT(tellings[1].partners, ElementsAre(0U));
  EXPECT_TRUE(tellings[2].told);
}

TEST(TellApart, KnowsWhatNoReadingDependsOn) {
  MatrixXd rows = MatrixXd::Zero(2, 2);
  rows(0, 0) = rows(1, 0) = 1.0;
  const auto tellings = tellApart(informationOf(rows), VectorXd::Ones(2), single(2));
  EXPECT_FALSE(tellings[1].told);
  EXPECT_FALSE(tellings[1].has_influence);
  EXPECT_TRUE(tellings[1].partners.empty());
}

TEST(TellApart, WhatIsToldWorseThanPlausibleIsNotTold) {
  MatrixXd rows(2, 2);
  rows << 1, 1,  //
      1, 1.001;  // told apart to 0.01 · sqrt(2) / 0.001 = 14
  EXPECT_FALSE(tellApart(informationOf(rows), VectorXd::Constant(2, 10.0), single(2))[1].told);
  EXPECT_TRUE(tellApart(informationOf(rows), VectorXd::Constant(2, 20.0), single(2))[1].told);
}

TEST(TellApart, ABlockWithAPriorNeedsMostOfItsDirections) {
  MatrixXd rows = MatrixXd::Zero(2, 3);
  rows(0, 0) = rows(1, 1) = 1.0;
  std::vector<ParameterChunk> chunks{{{0, 1, 2}, MatrixXd::Identity(3, 3)}};
  auto tellings = tellApart(informationOf(rows), VectorXd::Ones(3), chunks);
  EXPECT_TRUE(tellings[0].told);
  EXPECT_EQ(tellings[0].directions, 2);
  rows(1, 1) = 0.0;
  tellings = tellApart(informationOf(rows), VectorXd::Ones(3), chunks);
  EXPECT_FALSE(tellings[0].told);
}

TEST(RankOf, CountsIndependentColumns) {
  MatrixXd rows(4, 3);
  rows << 1, 0, 1, 0, 1, 1, 2, 1, 3, 1, -1, 0;
  EXPECT_EQ(rankOf(informationOf(rows), VectorXd::Ones(3)).rank, 2);
}

TEST(ChooseSetups, TakesTheOneThatFillsTheGap) {
  const MatrixXd known = Eigen::Vector2d(1e4, 0.0).asDiagonal();
  const std::vector<MatrixXd> setups{Eigen::Vector2d(1e4, 0.0).asDiagonal(),
                                     Eigen::Vector2d(0.0, 1e4).asDiagonal()};
  for (const Criterion criterion : {Criterion::D, Criterion::A}) {
    const auto chosen = chooseSetups(known, setups, VectorXd::Ones(2), criterion, 2);
    ASSERT_EQ(chosen.size(), 2U);
    EXPECT_EQ(chosen[0].setup, 1U);
    EXPECT_NEAR(chosen[0].d_gain, std::log(1e4 + 1.0), 1e-9);
    EXPECT_NEAR(chosen[0].a_gain, 1.0 - 1.0 / (1e4 + 1.0), 1e-9);
  }
}

TEST(QualityOf, IsZeroForNothingAndOneForEverything) {
  const PlanQuality nothing = qualityOf(MatrixXd::Zero(2, 2), VectorXd::Constant(2, 0.1));
  EXPECT_EQ(nothing.told, 0);
  EXPECT_NEAR(nothing.quality, 0.0, 1e-12);
  EXPECT_NEAR(nothing.sigma[0], 0.1, 1e-12);
  const PlanQuality all = qualityOf(1e12 * MatrixXd::Identity(2, 2), VectorXd::Constant(2, 0.1));
  EXPECT_EQ(all.told, 2);
  EXPECT_NEAR(all.quality, 1.0, 1e-9);
  EXPECT_NEAR(all.sigma[0], 1e-6, 1e-12);
  EXPECT_NEAR(all.condition_number, 1.0, 1e-9);
}

}  // namespace
}  // namespace nineline::estimation
