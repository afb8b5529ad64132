package org.starl.primitives;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Constructor;
import java.lang.reflect.Modifier;
import java.util.List;
import java.util.Set;
import java.util.SortedSet;
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
import org.starl.primitives.ledger.LedgerSpec;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.motion.MotionSpec;
import org.starl.primitives.mutex.MutexFact;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.paths.TubesSpec;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.spec.InstanceMonitor;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent.Action;

/** All specifications are made alike: of every instance, with bounds for progress. */
class SpecConventionTest {

  private static final ProcessId I = ProcessId.first(new RobotId("i"), 1);
  private static final ProcessId J = ProcessId.first(new RobotId("j"), 1);

  @ParameterizedTest
  @ValueSource(
      classes = {
        AgreementSpec.class,
        BarrierSpec.class,
        ElectionSpec.class,
        GeocastSpec.class,
        LedgerSpec.class,
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
    assertThat(lemmasAdded(new AgreementSpec(), new AgreementSpec(1)))
        .containsExactly("agreement.Decided", "agreement.Informed");
    assertThat(lemmasAdded(new BarrierSpec(), new BarrierSpec(1, 1)))
        .containsExactly("barrier.NotHung");
    assertThat(lemmasAdded(new ElectionSpec(), new ElectionSpec(1, 1)))
        .containsExactly("election.Elected", "election.Told");
    assertThat(lemmasAdded(new LedgerSpec(), new LedgerSpec(1, 1)))
        .containsExactly("ledger.Answered", "ledger.Freed");
    assertThat(lemmasAdded(new RegistrationSpec(), new RegistrationSpec(1)))
        .containsExactly("registration.Registered");
    assertThat(lemmasAdded(new TubesSpec(), new TubesSpec(1)))
        .containsExactly("tubes.Passed", "tubes.Told");
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
      enter(monitors, xid, I, 1);
      enter(monitors, xid, J, 2);
    }
    return (int) monitors.report().violations("mutex.Exclusive");
  }

  private static void enter(Monitors monitors, String xid, ProcessId who, long ts) {
    SortedSet<String> a = Sections.copyOf(Set.of("A"));
    for (MutexFact fact :
        List.of(
            new MutexFact.DoMutex(who, 1, ts, a, new TreeSet<>()),
            new MutexFact.OdMutex(who, 1, a))) {
      monitors.observe(Action.of(0, who.robot(), MutexFact.source(xid), MutexFact.SHAPE, fact));
    }
  }
}
