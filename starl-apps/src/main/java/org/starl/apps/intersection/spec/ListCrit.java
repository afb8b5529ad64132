package org.starl.apps.intersection.spec;

import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.apps.intersection.logic.CrossingTrace;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.id.RobotId;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/**
 * {@code Inv_list_crit} (paper, Figure 6): what a car still has to cross, it holds while it moves, has
 * requested while it waits, and at the start it is the whole path.
 *
 * <p>It is an invariant of states between atomic actions. One action writes several variables one
 * after the other, all at one time; so a car's state is looked at when the next event is of another
 * time or another robot.
 *
 * <p>In PVS the grant and the car's step from {@code mutex_wait} to {@code move_wait} are one action,
 * {@code od_mutex}. A program learns of its grant when it looks next, so between the two it still
 * waits for what it holds already, or for what has just been refused.
 */
final class ListCrit implements Monitor {

  private static final String LEMMA = "Inv_list_crit";

  private final Trips trips = new Trips();
  private final SortedMap<RobotId, State> states = new TreeMap<>();
  private final HeldZones zones;
  private @Nullable TraceEvent last;

  private static final class State {
    private Location location = Location.S_0;
    private List<String> myseq = List.of();
    private boolean told;
  }

  /** Of the mutex {@code xid}. */
  ListCrit(String xid) {
    zones = new HeldZones(xid);
  }

  @Override
  public List<String> lemmas() {
    return List.of(LEMMA);
  }

  @Override
  public List<String> ownLemmas() {
    return List.of(LEMMA);
  }

  @Override
  public String says(String lemma) {
    return "What a car still has to cross, it holds while it moves and has asked for while it "
        + "waits.";
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    if (last != null && (last.timeNs() != event.timeNs() || !last.robot().equals(event.robot()))) {
      check(last, report);
    }
    last = event;
    zones.observe(event);
    if (trips.observe(event)) {
      // A program that has started anew tells another path, from where the car stands.
      states.putIfAbsent(event.robot(), new State());
    } else if (event instanceof TraceEvent.Left) {
      states.remove(event.robot());
    } else if (event instanceof Variable variable
        && variable.source().equals(CrossingTrace.SOURCE)) {
      changed(variable);
    }
  }

  private void changed(Variable variable) {
    State state = states.get(variable.robot());
    if (state == null) {
      return; // of a car that has left the floor, and owes nothing
    }
    if (variable.name().equals(CrossingTrace.LOCATION)) {
      state.location = Location.valueOf(variable.value());
    } else if (variable.name().equals(CrossingTrace.MYSEQ)) {
      state.myseq = HeldZones.list(variable.value());
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
    if (state == null || state.told) {
      return;
    }
    report.checked(LEMMA);
    String wrong = whatIsWrong(robot, state);
    if (!wrong.isEmpty()) {
      state.told = true;
      report.violated(LEMMA, event.timeNs(), List.of(robot), wrong);
    }
  }

  private String whatIsWrong(RobotId robot, State state) {
    List<String> path = trips.of(robot);
    Set<String> rest = new TreeSet<>(state.myseq);
    String myseq = state.location + ": myseq " + state.myseq;
    return switch (state.location) {
      case S_0, REGISTER_WAIT, QUEUE ->
          state.myseq.equals(path) ? "" : myseq + " is not the path " + path;
      case MUTEX_WAIT ->
          zones.requested(robot).equals(rest)
                  || zones.held(robot).equals(rest)
                  || zones.isRefused(robot)
              ? ""
              : myseq + " is not what is requested, " + zones.requested(robot);
      case MOVE_WAIT ->
          zones.held(robot).containsAll(rest)
              ? ""
              : myseq + " is not all held, " + zones.held(robot);
      case RESUME, MUTEX_S, S_1, UNREGISTER_WAIT, DONE -> "";
    };
  }
}
