package org.starl.apps.intersection.spec;

import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.HeldSections;
import org.starl.primitives.mutex.MutexFact;
import org.starl.primitives.registration.RegistrationAction;
import org.starl.spec.LemmaMonitor;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * {@code Inv_list_crit} (paper, Figure 6): the zones ahead of a car ({@code myseq}) are its whole path
 * at the start, are requested while it waits, and are held while it moves. A car that has requested
 * them as a sequence has only requested them while it moves: {@code occupied_is_held} says what it
 * holds.
 *
 * <p>It is an invariant of the states between atomic actions. One action writes several variables one
 * after the other, all at one time. So a car's state is checked when the next event is of another time
 * or another robot. A copy that is lost on its way is an event of its receiver, but belongs to the
 * sender's action, and is passed over.
 *
 * <p>In PVS the grant and the car's step from {@code mutex_wait} to {@code move_wait} are one action,
 * {@code od_mutex}. A program sees the grant, or the refusal, at its next step. Between the two it is
 * still in MUTEX_WAIT, so there its latest request counts, granted or not.
 *
 * <p>{@code registers}: a car that was told to register does so before it asks again.
 */
public final class ListCrit extends LemmaMonitor {

  private static final String LEMMA = "intersection.Inv_list_crit";

  static final String REGISTERS = "intersection.registers";

  private final SortedMap<RobotId, State> states = new TreeMap<>();
  private final Instance mutex;
  private final HeldSections zones = new HeldSections();
  private @Nullable TraceEvent last;

  private static final class State {
    private Location location = Location.S_0;
    private List<String> path = List.of();
    private List<String> myseq = List.of();
    private Set<String> ahead = Set.of();
    private Set<String> requested = Set.of();
    private boolean isSequence;
    private boolean isReported;
    private boolean mustRegister;

    // What is wrong; null if it must be looked at again, because something has changed.
    private @Nullable String wrong;

    void setMyseq(List<String> zones) {
      myseq = zones;
      ahead = new TreeSet<>(zones);
    }
  }

  /** Of the mutex {@code xid}. */
  public ListCrit(String xid) {
    mutex = MutexFact.source(xid);
    lemma(
        LEMMA,
        "A car holds the zones ahead of it while it moves, and has requested them while it waits.");
    lemma(REGISTERS, "A car that was told to register does so before it asks again.");
  }

  @Override
  public List<String> perRobotLemmas() {
    return List.of(LEMMA, REGISTERS);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    if (event instanceof TraceEvent.Dropped) {
      return;
    }
    if (last != null && (last.timeNs() != event.timeNs() || !last.robot().equals(event.robot()))) {
      check(last, report);
    }
    last = event;
    switch (event) {
      case Action action -> acted(action, report);
      case Variable variable -> changed(variable);
      case TraceEvent.Left left -> states.remove(left.robot());
      case TraceEvent.Fault fault
          when fault.name().equals(TraceEvent.Fault.CRASH) && states.containsKey(fault.robot()) ->
          states.get(fault.robot()).mustRegister = false;
      default -> {
        // Neither a car's zones nor its location.
      }
    }
  }

  private void acted(Action action, Report report) {
    if (action.fact() instanceof MutexFact fact && fact.action().isPresent()) {
      zones.observe(action);
      states.values().forEach(state -> state.wrong = null);
    }
    // A restarted program writes another trip, from where the car stands.
    CrossingFact.trip(action)
        .ifPresent(
            trip -> states.computeIfAbsent(action.robot(), r -> new State()).path = trip.zones());
    State state = states.get(action.robot());
    if (state != null) {
      state.wrong = null;
      if (action.fact() instanceof MutexFact.DoMutex request && action.source().equals(mutex)) {
        state.requested = request.want();
        state.isSequence = !request.sequence().isEmpty();
      }
      checkRegisters(action, state, report);
    }
  }

  private void checkRegisters(Action action, State state, Report report) {
    if (!action.source().xid().equals(mutex.xid())) {
      return; // the queue's
    }
    switch (action.fact()) {
      case RegistrationAction.do_register asked -> state.mustRegister = false;
      case MutexFact.DoMutex request -> report.checked(REGISTERS);
      case MutexFact.Withdraw end when end.why().mustRegister() -> {
        report.checked(REGISTERS);
        if (state.mustRegister && end.num() == 0) {
          String detail = "asks again, and has not registered";
          report.violated(REGISTERS, action.timeNs(), List.of(action.robot()), detail);
        }
        state.mustRegister = true;
      }
      default -> {
        // It asks for nothing.
      }
    }
  }

  private void changed(Variable variable) {
    State state = states.get(variable.robot());
    if (state != null && variable.source().equals(Instance.APP)) {
      state.wrong = null;
      CrossingFact.location(variable).ifPresent(location -> state.location = location);
      CrossingFact.myseq(variable).ifPresent(state::setMyseq);
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    if (last != null) {
      check(last, report);
    }
  }

  private void check(TraceEvent event, Report report) {
    RobotId robot = event.robot();
    State state = states.get(robot);
    if (state == null || state.isReported) {
      return;
    }
    report.checked(LEMMA);
    String wrong = state.wrong;
    if (wrong == null) {
      wrong = violation(robot, state);
      state.wrong = wrong;
    }
    if (!wrong.isEmpty()) {
      state.isReported = true;
      report.violated(LEMMA, event.timeNs(), List.of(robot), wrong);
    }
  }

  /** Empty if the invariant holds. */
  private String violation(RobotId robot, State state) {
    return switch (state.location) {
      case S_0, REGISTER_WAIT, QUEUE ->
          state.myseq.equals(state.path) ? "" : myseq(state) + " is not the path " + state.path;
      case MUTEX_WAIT ->
          state.requested.equals(state.ahead)
              ? ""
              : myseq(state) + " is not the latest request " + state.requested;
      case MOVE_WAIT ->
          (state.isSequence && state.requested.containsAll(state.ahead))
                  || zones.holdsAll(robot, state.myseq)
              ? ""
              : myseq(state) + " is not all held, " + zones.held(robot);
      case RESUME, MUTEX_S, S_1, UNREGISTER_WAIT, DONE -> "";
    };
  }

  private static String myseq(State state) {
    return state.location + ": myseq " + state.myseq;
  }
}
