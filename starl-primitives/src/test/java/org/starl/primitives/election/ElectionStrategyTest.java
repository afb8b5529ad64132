package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.election.ElectionStrategy.Propose;
import org.starl.primitives.election.ElectionStrategy.Wait;

/** What each strategy proposes, and when; a message delay is 10 ns. */
class ElectionStrategyTest {

  private static final long BEGAN = 1_000;
  private static final long LISTENED = BEGAN + 2 * 10;
  private static final long DECIDE = 6 * 10;
  private static final ProcessId LOW = ProcessId.first(new RobotId("a"), 1);
  private static final ProcessId ME = ProcessId.first(new RobotId("m"), 1);
  private static final ProcessId HIGH = ProcessId.first(new RobotId("z"), 1);

  private final Candidates poll = new Candidates(ME, 0, BEGAN, 10);

  /** By hand: one turn of six delays for each candidate with a higher draw, or an equal one and a higher id. */
  @Property(tries = 100)
  void randomBallotsGoInTurns(@ForAll @Size(4) List<@LongRange(min = -2, max = 2) Long> draws) {
    Candidates all = new Candidates(ME, 0, BEGAN, 10);
    int before = 0;
    ProcessId first = ME;
    long firstDraw = 0;
    for (int i = 0; i < draws.size(); i++) {
      ProcessId id = ProcessId.first(new RobotId(List.of("a", "b", "y", "z").get(i)), 1);
      long draw = draws.get(i);
      all.heard(id, draw, LISTENED);
      before += draw > 0 || (draw == 0 && id.compareTo(ME) > 0) ? 1 : 0;
      if (draw > firstDraw || (draw == firstDraw && id.compareTo(first) > 0)) {
        first = id;
        firstDraw = draw;
      }
    }
    assertThat(plan(all, LISTENED - 1)).isEqualTo(new Wait(LISTENED));
    assertThat(plan(all, LISTENED))
        .isEqualTo(before == 0 ? new Propose(first) : new Wait(LISTENED + before * DECIDE));
  }

  @Test
  void aCandidateThatWasSilentForADecisionHasNoTurn() {
    poll.heard(HIGH, 5, LISTENED);
    assertThat(plan(poll, LISTENED + DECIDE)).isEqualTo(new Propose(HIGH));
    assertThat(plan(poll, LISTENED + DECIDE + 1)).isEqualTo(new Propose(ME));
  }

  @Test
  void aBullyWaitsForHigherIdsOfTheRound() {
    for (long round = 0; round < 3; round++) {
      long began = BEGAN + round * (2 * 10 + DECIDE);
      assertThat(bully(began)).isEqualTo(new Wait(began + 20));
      assertThat(bully(began + 20)).isEqualTo(new Propose(ME));
      poll.heard(LOW, 0, began);
      assertThat(bully(began + 20)).isEqualTo(new Propose(ME));
      poll.heard(HIGH, 0, began);
      assertThat(bully(began + 20)).isEqualTo(new Wait(began + 20 + DECIDE));
    }
  }

  @Test
  void onlyTheFirstCandidacyOfAnotherIsNew() {
    assertThat(poll.heard(ME, 3, BEGAN)).isFalse();
    assertThat(poll.heard(HIGH, 3, BEGAN)).isTrue();
    assertThat(poll.heard(HIGH, 3, BEGAN + 1)).isFalse();
    poll.strike(HIGH);
    assertThat(poll.byDraw(BEGAN)).containsExactly(ME);
  }

  private static ElectionStrategy.Plan plan(Candidates candidates, long now) {
    return ElectionStrategy.RANDOM_BALLOT.plan(candidates, now);
  }

  private ElectionStrategy.Plan bully(long now) {
    return ElectionStrategy.BULLY.plan(poll, now);
  }
}
