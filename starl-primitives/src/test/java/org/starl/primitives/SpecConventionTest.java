package org.starl.primitives;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Constructor;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.barrier.BarrierSpec;
import org.starl.primitives.election.ElectionSpec;
import org.starl.primitives.geocast.GeocastSpec;
import org.starl.primitives.motion.MotionSpec;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.paths.TubesSpec;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.spec.InstanceMonitor;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent.Action;

/** All specifications are made alike: of every instance, with bounds for progress. */
class SpecConventionTest {

  private static final ProcessId I = new ProcessId(new RobotId("i"), 1);
  private static final ProcessId J = new ProcessId(new RobotId("j"), 1);

  @ParameterizedTest
  @ValueSource(
      classes = {
        AgreementSpec.class,
        BarrierSpec.class,
        ElectionSpec.class,
        GeocastSpec.class,
        MotionSpec.class,
        MutexSpec.class,
        RegistrationSpec.class,
        TubesSpec.class
      })
  void withoutArgumentsItIsOfEveryInstance(Class<? extends Monitor> spec) throws Exception {
    assertThat(spec.getConstructor().newInstance().lemmas()).isNotEmpty();
    for (Constructor<?> constructor : spec.getConstructors()) {
      assertThat(constructor.getParameterTypes()).as("no xid").doesNotContain(String.class);
      assertThat(Modifier.isPublic(constructor.getModifiers())).isTrue();
    }
  }

  @Test
  void boundsAddLemmasOfProgress() {
    assertThat(lemmasAdded(new AgreementSpec(), new AgreementSpec(1))).containsExactly("Decided");
    assertThat(lemmasAdded(new BarrierSpec(), new BarrierSpec(1, 1))).containsExactly("NotHung");
    assertThat(lemmasAdded(new ElectionSpec(), new ElectionSpec(1, 1)))
        .containsExactly("Elected", "Told");
    assertThat(lemmasAdded(new RegistrationSpec(), new RegistrationSpec(1)))
        .containsExactly("Registered");
    assertThat(lemmasAdded(new TubesSpec(), new TubesSpec(1))).containsExactly("Told");
  }

  @Test
  void everyMutexIsCheckedOrTheOneThatIsNamed() {
    assertThat(violations(new MutexSpec())).isEqualTo(2);
    assertThat(violations(new MutexSpec().only("north"))).isEqualTo(1);
    assertThat(violations(new MutexSpec().only("orth"))).isZero();
  }

  private static Set<String> lemmasAdded(Monitor safety, Monitor progress) {
    Set<String> added = new TreeSet<>(progress.lemmas());
    added.removeAll(safety.lemmas());
    return added;
  }

  /** Both robots are in section A of both mutexes. */
  private static int violations(InstanceMonitor<?> spec) {
    Monitors monitors = new Monitors(List.of(spec));
    for (String xid : List.of("north", "south")) {
      act(monitors, xid, I, "do_mutex", "1", "1", "A", "");
      act(monitors, xid, I, "od_mutex", "1", "A");
      act(monitors, xid, J, "do_mutex", "1", "2", "A", "");
      act(monitors, xid, J, "od_mutex", "1", "A");
    }
    return (int) monitors.report().violations("Exclusive");
  }

  private static void act(
      Monitors monitors, String xid, ProcessId who, String name, String... args) {
    List<String> all = new ArrayList<>(List.of(args));
    all.add(0, who.toString());
    monitors.observe(new Action(0, who.robot(), "mutex/" + xid, name, all));
  }
}
