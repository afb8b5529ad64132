package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;

class PendingChangesTest {

  private static final ProcessId OLD = ProcessId.first(new RobotId("bot0"), 1);

  @Test
  void anIdleIdIsNewOnceAndLingersInTheViewsThatMentionIt() {
    PendingChanges changes = new PendingChanges(OLD.robot(), new NoPort());
    changes.addOwn(OLD);
    View listed = View.NONE.next().with(OLD);
    assertThat(changes.lingersIn(listed)).isFalse();
    assertThat(changes.markIdle(OLD)).isTrue();
    assertThat(changes.markIdle(OLD)).isFalse();
    assertThat(changes.lingersIn(listed)).isTrue();
    assertThat(changes.lingersIn(View.NONE)).isFalse();
    assertThat(changes.in(listed, null, null).leave()).containsExactly(OLD);
    View ghost = listed.confined(OLD, new TreeSet<>(List.of("A")));
    assertThat(changes.in(ghost, null, null).leave()).as("a ghost, too").containsExactly(OLD);
  }

  @Test
  void aConfinementIsWantedUntilItIsMadeOrItsFencerHasGone() {
    ProcessId fencer = ProcessId.first(new RobotId("bot1"), 1);
    Confinement confinement =
        new Confinement(OLD, new TreeSet<>(List.of("A")), new TreeSet<>(List.of(fencer)));
    View listed = View.NONE.next().with(OLD).with(fencer);
    for (View over : List.of(confinement.applyTo(listed), listed.without(fencer))) {
      List<Confinement> told = new ArrayList<>();
      PendingChanges changes =
          new PendingChanges(
              fencer.robot(),
              new NoPort() {
                @Override
                public void confines(Confinement its) {
                  told.add(its);
                }
              });
      changes.confine(confinement);
      assertThat(changes.in(listed, null, null).confine()).containsExactly(confinement);
      assertThat(changes.in(over, null, null).confine()).as("%s", over).isEmpty();
      assertThat(told).containsExactly(confinement);
    }
  }

  private static class NoPort implements RegistrationPort {
    @Override
    public void sendReliably(RobotId to, SynodMessage message, Runnable settled) {
      throw new IllegalStateException("sends " + message);
    }

    @Override
    public ProcessId freshProcess() {
      throw new IllegalStateException("asks for an id");
    }

    @Override
    public void acted(RegistrationAction action) {
      throw new IllegalStateException("traces " + action);
    }

    @Override
    public void confines(Confinement confinement) {
      throw new IllegalStateException("traces " + confinement);
    }
  }
}
