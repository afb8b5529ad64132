package org.starl.workload;

import java.util.List;
import java.util.TreeSet;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.primitives.registration.Registration;
import org.starl.primitives.registration.RegistrationSettings;
import org.starl.random.Rng;

/**
 * A robot that uses a primitive in rounds. In each it asks for something, which it is given or told
 * that it will not be; then it asks again. A robot that starts anew does all its rounds.
 */
abstract class Client extends LogicThread {

  /** {@code source} of what clients trace. */
  static final String SOURCE = "workload";

  /** Action with the round's number: asks now. */
  static final String ASK = "ask";

  /** Action with the round's number: has what it asked for. */
  static final String SERVED = "served";

  /** Action with the round's number: was told that it will not have it. */
  static final String TOLD = "told";

  private static final long NS_PER_MS = 1_000_000;

  /** What the robot draws for itself; each start of its program differs. */
  protected final Rng rng;

  private final Course course;
  private final long thinkMs;

  /**
   * @param thinkMs a robot waits so long at most before it asks
   */
  Client(GlobalVarHolder gvh, Course course, long thinkMs) {
    super(gvh);
    this.course = course;
    this.thinkMs = thinkMs;
    rng = gvh.plat.entropy.fork(SOURCE + gvh.id.boot());
  }

  @Override
  public final List<Object> callStarL() {
    int told = 0;
    for (int round = 0; round < course.rounds(); round++) {
      sleep(Math.max(0, course.beginMs(round) - gvh.plat.clock.nowNs() / NS_PER_MS));
      while (!isDone(round)) {
        told++;
      }
    }
    leave();
    return List.of(course.rounds() + " rounds, told " + told + " times");
  }

  private boolean isDone(int round) {
    sleep(rng.nextLong(0, thinkMs));
    prepare();
    gvh.trace.action(SOURCE, ASK, round);
    boolean served = obtain(round);
    gvh.trace.action(SOURCE, served ? SERVED : TOLD, round);
    if (served) {
      use();
    }
    return served;
  }

  /** What a robot needs before it can ask. */
  protected void prepare() {}

  /**
   * Asks, and waits for the answer.
   *
   * @param round from 0
   * @return whether it was served; else it has been told that it will not be
   */
  protected abstract boolean obtain(int round);

  /** Uses what it was given, and gives it back. */
  protected void use() {}

  /** After the last round. */
  protected void leave() {}

  /** One's place in a group to which everybody of the deployment may belong. */
  protected final Registration registration(String xid, RegistrationSettings settings) {
    Registration registration = new Registration(gvh, xid, gvh.id.participants(), settings);
    if (gvh.id.boot() > 1) {
      registration.standsIn(new TreeSet<>()); // who this robot was before is nowhere
    }
    return registration;
  }
}
