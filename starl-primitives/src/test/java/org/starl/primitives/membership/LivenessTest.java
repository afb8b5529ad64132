package org.starl.primitives.membership;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.MutexFact;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;

class LivenessTest {

  private static final RobotId BOT = new RobotId("bot1");
  private final Liveness liveness = new Liveness();

  @Test
  void aCrashBeforeTheBootNumberIsStoredEndsNoStart() {
    crash();
    acts(1);
    crash();
    acts(2);
    assertThat(liveness.isDead(id(1))).isTrue();
    assertThat(liveness.isDead(id(2))).isFalse();
  }

  @Test
  void aRobotThatUsesItsIdAgainAfterACrashIsNotDead() {
    acts(1);
    crash();
    assertThat(liveness.isDead(id(1))).isTrue();
    acts(1);
    assertThat(liveness.isDead(id(1))).isFalse();
  }

  @Test
  void aRobotThatCrashesBeforeItActsIsDeadUntilItActs() {
    crash();
    assertThat(liveness.isDead(id(1))).isTrue();
    acts(1);
    assertThat(liveness.isDead(id(1))).isFalse();
  }

  private void crash() {
    liveness.observe(new Fault(0, BOT, Fault.CRASH, ""));
    liveness.observe(new Fault(1, BOT, Fault.RESTART, "lost"));
  }

  private void acts(long start) {
    MutexFact fact = new MutexFact.StandsIn(id(start), Sections.NONE);
    liveness.observe(Action.of(2, BOT, MutexFact.source("x"), MutexFact.SHAPE, fact));
  }

  private static ProcessId id(long start) {
    return ProcessId.first(BOT, start);
  }
}
