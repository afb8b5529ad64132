package org.starl.primitives;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.primitives.agreement.SetAgreement;
import org.starl.primitives.barrier.Barrier;
import org.starl.primitives.election.Election;
import org.starl.primitives.geocast.Broadcast;
import org.starl.primitives.geocast.Geocast;
import org.starl.primitives.motion.MotionControl;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.registration.Registration;

class PaperNamesTest {

  /** The names of methods that the paper prints and Java's conventions would not. */
  private static final Set<String> OF_THE_PAPER =
      Set.of(
          "BCast",
          "Gcastflag",
          "Leader",
          "do_election",
          "do_geocast",
          "do_move",
          "do_mutex",
          "do_register",
          "motion_stop",
          "od_mutex");

  private static final List<Class<?>> FACADES =
      List.of(
          Barrier.class,
          Broadcast.class,
          DistributedPathPlanning.class,
          Election.class,
          Geocast.class,
          M_Mutex.class,
          MotionControl.class,
          Registration.class,
          SetAgreement.class);

  @Test
  void onlyNamesThatThePaperPrintsAreNotJavas() {
    Set<String> others = new TreeSet<>();
    for (Class<?> facade : FACADES) {
      for (Method method : facade.getMethods()) {
        boolean isApi = Modifier.isPublic(method.getModifiers()) && !method.isSynthetic();
        if (isApi && !method.getName().matches("[a-z][A-Za-z0-9]*")) {
          others.add(method.getName());
        }
      }
    }
    assertThat(others).isEqualTo(OF_THE_PAPER);
  }
}
