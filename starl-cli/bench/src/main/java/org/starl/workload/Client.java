package org.starl.workload;

import java.util.List;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.Participants;
import org.starl.primitives.registration.Registration;
import org.starl.primitives.registration.RegistrationSettings;
import org.starl.random.Rng;
import org.starl.time.Time;

/**
 * A robot that uses a primitive in rounds. In each round it repeats a request until the request
 * succeeds. A restarted robot does all its rounds again.
 */
abstract class Client extends LogicThread {

  /** The robot's own random numbers; different after each restart. */
  protected final Rng rng;

  private final Course course;
  private final long thinkMs;

  /**
   * @param thinkMs maximum time that a robot waits before a request
   */
  Client(GlobalVarHolder gvh, Setup setup, long thinkMs) {
    super(gvh);
    course = setup.course();
    this.thinkMs = thinkMs;
    rng = gvh.plat.entropy.fork(ClientFact.SOURCE.name() + gvh.id.boot());
  }

  @Override
  public final List<Object> callStarL() {
    int told = 0;
    for (int round = 0; round < course.allRounds(); round++) {
      pause(Math.max(0, course.beginMs(round) - gvh.plat.clock.nowNs() / Time.NS_PER_MS));
      while (!isDone(round)) {
        told++;
      }
    }
    leave();
    return List.of(course.allRounds() + " rounds, told " + told + " times");
  }

  private boolean isDone(int round) {
    pause(rng.nextLong(0, thinkMs));
    prepare();
    record(new ClientFact.ask(round));
    boolean served = obtain(round);
    record(served ? new ClientFact.served(round) : new ClientFact.told(round));
    if (served) {
      use();
    }
    return served;
  }

  /** As {@link #sleep}; fails if it ends too early, and traces if it ends too late. */
  protected final void pause(long ms) {
    long dueNs = gvh.plat.clock.nowNs() + ms * Time.NS_PER_MS;
    sleep(ms);
    checkWoken(dueNs, ms, false);
  }

  /** As {@link #await} with a timeout; fails and traces as {@link #pause} does. */
  protected final boolean isTrueWithin(BooleanSupplier condition, long ms) {
    long dueNs = gvh.plat.clock.nowNs() + ms * Time.NS_PER_MS;
    boolean held = await(condition, ms);
    if (held != condition.getAsBoolean()) {
      throw new IllegalStateException("await returned " + held + ": the condition says otherwise");
    }
    checkWoken(dueNs, ms, held);
    return held;
  }

  private void checkWoken(long dueNs, long ofMs, boolean mayBeEarly) {
    long lateNs = gvh.plat.clock.nowNs() - dueNs;
    if (lateNs < 0 && !mayBeEarly) {
      throw new IllegalStateException("woken " + -lateNs + " ns too early");
    }
    if (lateNs >= Time.NS_PER_MS) {
      record(new ClientFact.late(lateNs / Time.NS_PER_MS, ofMs));
    }
  }

  private void record(ClientFact fact) {
    gvh.trace.action(ClientFact.SOURCE, ClientFact.SHAPE, fact);
  }

  /** Prepares a request. */
  protected void prepare() {}

  /**
   * Makes a request and waits until it has succeeded or failed.
   *
   * @param round from 0
   * @return whether it succeeded
   */
  protected abstract boolean obtain(int round);

  /** After a successful request: uses the primitive's result, then releases it. */
  protected void use() {}

  /** After the last round. */
  protected void leave() {}

  /** A registration that all robots of the deployment may join. */
  protected final Registration registration(String xid, RegistrationSettings settings) {
    return registration(xid, gvh.id.participants(), settings);
  }

  /** With these acceptors, which are the same on every robot. */
  protected final Registration registration(
      String xid, Participants acceptors, RegistrationSettings settings) {
    Registration registration = new Registration(gvh, xid, acceptors, settings);
    if (gvh.id.boot() > 1) {
      registration.standsIn(new TreeSet<>()); // the previous incarnation is in no section
    }
    return registration;
  }

  /** Returns when {@code registration} admits requests. */
  protected final void register(Registration registration) {
    while (!registration.mayRequest()) {
      registration.do_register();
      await(() -> registration.mayRequest() || registration.failed().get());
    }
  }

  /** Returns when this robot is unregistered. */
  protected final void unregister(Registration registration) {
    while (!registration.isUnregistered()) {
      registration.unregister();
      await(() -> registration.isUnregistered() || registration.failed().get());
    }
  }
}
