package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.primitives.agreement.SynodStates.Shape;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.StateSearch.Outcome;

/** All states of the Synod's code on small instances. */
class SynodExplorationTest {

  private static final int MOST_STATES = 1_000_000;

  private static Outcome explore(Shape shape) {
    return new StateSearch<>(new SynodStates(shape)).run(MOST_STATES, states -> {});
  }

  private static void assertAgrees(Shape shape) {
    Outcome outcome = explore(shape);
    assertThat(outcome.violation()).isEmpty();
    assertThat(outcome.isComplete()).isTrue();
    assertThat(outcome.reached()).isPositive();
  }

  @Test
  void aProposerAndACrash() {
    assertAgrees(new Shape(2, 2, 1, 1, 1, false));
  }

  @Test
  void twoProposers() {
    assertAgrees(new Shape(2, 2, 2, 0, 0, false));
  }

  @Test
  void twoProposersWithOneVoterAndACrash() {
    assertAgrees(new Shape(2, 1, 2, 0, 1, false));
  }

  @Test
  void anAcceptorThatForgetsIsFoundWithItsSteps() {
    Outcome outcome = explore(new Shape(2, 1, 2, 0, 1, true));
    assertThat(outcome.violation()).last().asString().startsWith("Agreement");
  }

  @Test
  void threeVotersAndACrash() {
    assertAgrees(new Shape(3, 3, 1, 0, 1, false));
  }

  @Test
  void threeVotersAndTwoProposers() {
    assertAgrees(new Shape(3, 3, 2, 0, 0, false));
  }
}
