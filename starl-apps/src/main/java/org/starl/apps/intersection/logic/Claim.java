package org.starl.apps.intersection.logic;

import java.util.Collection;
import java.util.List;
import java.util.SortedSet;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.starl.GlobalVarHolder;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexFailure;
import org.starl.primitives.mutex.PipelinePrim;
import org.starl.primitives.registration.Registration;
import org.starl.time.Time;

/**
 * A car's claim to a sequence of places or zones. It registers, asks the mutex for the sequence at a good
 * time, and unregisters after it has released all of it. It asks again when a primitive reports a failure.
 * Strand only.
 */
final class Claim {

  private static final long RETRY_NS = Time.NS_PER_S;

  private enum State {
    OUT,
    REGISTERING,
    REGISTERED,
    ASKING,
    LEAVING,
    GONE
  }

  private final GlobalVarHolder gvh;
  private final RobotId self;
  private final Registration reg;
  private final PipelinePrim mutex;
  private final BooleanSupplier isGoodTime;
  private final boolean restarted;
  private List<String> rest = List.of();
  // Where the body may have been when the program restarted, as far as it may still be there.
  private List<String> stands = List.of();
  private State state = State.OUT;
  private boolean isInside;
  private long askFromNs;

  /**
   * @param xid instance of the registration and the mutex
   * @param acceptors of the registration
   * @param isGoodTime whether to ask now; only the first request waits for it
   */
  Claim(GlobalVarHolder gvh, String xid, Participants acceptors, BooleanSupplier isGoodTime) {
    this.gvh = gvh;
    this.isGoodTime = isGoodTime;
    self = gvh.id.name();
    restarted = gvh.id.boot() > 1;
    reg = new Registration(gvh, xid, acceptors);
    mutex = new M_Mutex(gvh, xid, reg);
  }

  /** Wants {@code sections}, in this order; the car must hold each before it enters it. */
  void want(List<String> sections) {
    rest = List.copyOf(sections);
  }

  /**
   * After a restart of the program.
   *
   * @param occupied the sections that the body may be in
   * @param sections these and those ahead; none if the sequence is over
   */
  void resume(Collection<String> occupied, List<String> sections) {
    isInside = !occupied.isEmpty();
    declare(List.copyOf(occupied), List.copyOf(sections));
  }

  private void declare(List<String> occupied, List<String> sections) {
    stands = occupied;
    rest = sections;
    mutex.resume(stands, rest);
  }

  /** Declares again what it claims without access to any of it: others wait for what it claims. */
  private void correct(List<String> occupied, List<String> sections) {
    if (state == State.ASKING) {
      mutex.withdraw();
      state = State.REGISTERED;
    }
    declare(occupied, sections);
  }

  /** The first place after a restart may have been rough: the body is not in these sections. */
  void knows(Predicate<String> isClear) {
    if (stands.isEmpty()) {
      return;
    }
    List<String> still = stands.stream().filter(isClear.negate()).collect(Collectors.toList());
    if (held().isEmpty() && still.size() < stands.size()) {
      correct(still, rest);
    }
  }

  /**
   * The body has left a section on its way: it held this, or stood there when the program restarted,
   * and got no access since then.
   *
   * @return whether it had no access
   */
  boolean leave(String section) {
    if (held().contains(section)) {
      release(section);
      return false;
    }
    boolean isCorrected = held().isEmpty() && stands.contains(section);
    if (isCorrected) {
      correct(without(stands, section), without(rest, section));
    }
    return isCorrected;
  }

  private static List<String> without(List<String> sections, String section) {
    return sections.stream().filter(each -> !each.equals(section)).collect(Collectors.toList());
  }

  /** The sections that are wanted or held, in order. */
  List<String> rest() {
    return rest;
  }

  SortedSet<String> held() {
    return mutex.held();
  }

  /** Number of others that are known to hold or to wait for all of {@code sections}. */
  int contenders(String... sections) {
    return mutex.contenders(sections);
  }

  boolean isRegistered() {
    return state == State.REGISTERED || state == State.ASKING;
  }

  boolean isAsking() {
    return state == State.ASKING;
  }

  /** Whether neither this process nor an earlier one of this robot is registered or wants a section. */
  boolean isOver() {
    boolean isOut = state == State.GONE || state == State.OUT;
    return isOut && rest.isEmpty() && !(restarted && isMentioned());
  }

  private boolean isMentioned() {
    return reg.view().number() == 0
        || reg.view().mentioned().stream().anyMatch(id -> id.robot().equals(self));
  }

  /** Releases a section, which must be held; after the last one it unregisters. */
  private void release(String section) {
    mutex.release(section);
    rest = without(rest, section);
    stands = without(stands, section);
    if (rest.isEmpty()) {
      end();
    }
  }

  private void end() {
    reg.unregister();
    state = State.LEAVING;
  }

  /** Takes the next step; call it once a period. */
  void step() {
    switch (state) {
      case OUT -> {
        if (!rest.isEmpty()) {
          reg.do_register();
          state = State.REGISTERING;
        }
      }
      case REGISTERING -> {
        if (reg.getList() != null) {
          state = State.REGISTERED;
          step();
        } else if (reg.failed().get()) {
          state = State.OUT;
        }
      }
      case REGISTERED -> {
        if (rest.isEmpty()) {
          end();
          return;
        }
        boolean isAgain = askFromNs > 0 || isInside || !held().isEmpty();
        if (gvh.plat.clock.nowNs() >= askFromNs && (isAgain || isGoodTime.getAsBoolean())) {
          mutex.doSequence(rest);
          state = State.ASKING;
          if (mutex.failed().get()) {
            step(); // given up as crashed, meanwhile
          }
        }
      }
      case ASKING -> {
        if (mutex.failed().get()) {
          boolean isAtOnce = mutex.failure().get() == MutexFailure.LATE;
          askFromNs = gvh.plat.clock.nowNs() + (isAtOnce ? 0 : RETRY_NS);
          state = mutex.failure().get().mustRegister() ? State.OUT : State.REGISTERED;
        }
      }
      case LEAVING -> {
        if (reg.isUnregistered()) {
          state = State.GONE;
        } else if (reg.failed().get()) {
          reg.unregister();
        }
      }
      case GONE -> {
        // There is nothing to do.
      }
    }
  }
}
