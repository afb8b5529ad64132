package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.Measures;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.apps.intersection.logic.CrossingTrace;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** Who came, registered, waited and crossed, and when. */
final class IntersectionStory implements Story {

  private static final double NS_PER_S = 1e9;

  private final SortedMap<RobotId, List<Crossed>> cars = new TreeMap<>();

  /** One trip. Times in ns; negative for what has not happened. */
  private static final class Crossed {
    private String trip = "?";
    private String rest = "";
    private long crashedNs = -1;
    private long arrivedNs = -1;
    private long askedNs = -1;
    private long grantedNs = -1;
    private long leftNs = -1;
    private long doneNs = -1;
    private int bumps;
  }

  @Override
  public void observed(TraceEvent event) {
    switch (event) {
      case Action action -> {
        if (action.source().equals(CrossingTrace.SOURCE)
            && action.name().equals(CrossingTrace.TRIP)) {
          car(action.robot()).trip = action.args().get(0);
        }
      }
      case Variable variable -> changed(variable);
      case TraceEvent.Joined joined -> arrived(joined.robot(), joined.timeNs());
      case TraceEvent.Left left -> car(left.robot()).leftNs = left.timeNs();
      case TraceEvent.Fault fault -> {
        if (fault.name().equals(TraceEvent.Fault.CRASH)) {
          car(fault.robot()).crashedNs = fault.timeNs();
        }
      }
      default -> {
        // No part of the story.
      }
    }
  }

  private void arrived(RobotId robot, long timeNs) {
    Crossed last = car(robot);
    if (last.arrivedNs < 0) {
      last.arrivedNs = timeNs;
      return;
    }
    Crossed again = new Crossed();
    again.trip = last.trip;
    again.arrivedNs = timeNs;
    trips(robot).add(again);
  }

  private void changed(Variable variable) {
    Crossed car = car(variable.robot());
    if (variable.name().equals(CrossingTrace.LOCATION)
        && variable.source().equals(CrossingTrace.SOURCE)) {
      switch (Location.valueOf(variable.value())) {
        case MUTEX_WAIT -> {
          if (car.askedNs < 0) {
            car.askedNs = variable.timeNs();
          }
        }
        case MOVE_WAIT -> car.grantedNs = variable.timeNs();
        case DONE -> car.doneNs = variable.timeNs();
        default -> {
          // On its way between two of these.
        }
      }
    } else if (variable.name().equals("myseq") && variable.source().equals(CrossingTrace.SOURCE)) {
      car.rest = variable.value();
    } else if (variable.name().equals("motionflag") && variable.value().equals("FAIL")) {
      car.bumps++;
    }
  }

  @Override
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    cars.forEach((robot, trips) -> {
      for (Crossed trip : trips) {
        lines.add(line(robot, trip));
      }
    });
    return lines;
  }

  private static String line(RobotId robot, Crossed car) {
    StringBuilder line = new StringBuilder(robot + " (" + car.trip + ")");
    if (car.arrivedNs < 0) {
      return line.append(" never came onto the floor").toString();
    }
    line.append(" came at ").append(seconds(car.arrivedNs));
    if (car.askedNs >= 0) {
      line.append(", was registered at ").append(seconds(car.askedNs));
    }
    if (car.grantedNs >= 0) {
      line.append(", waited ").append(seconds(car.grantedNs - car.askedNs));
    } else if (car.askedNs >= 0 && car.crashedNs < 0) {
      line.append(", still waits for ").append(car.rest);
    }
    if (car.bumps > 0) {
      line.append(", was stopped ").append(car.bumps == 1 ? "once" : car.bumps + " times");
    }
    if (car.leftNs >= 0) {
      line.append(", was across at ").append(seconds(car.leftNs));
    }
    if (car.doneNs > 0) {
      line.append(", had unregistered at ").append(seconds(car.doneNs));
    }
    if (car.crashedNs >= 0) {
      line.append(", crashed at ").append(seconds(car.crashedNs));
      if (car.grantedNs >= 0 && car.leftNs < 0) {
        line.append(" with ").append(car.rest).append(" before it");
      }
    }
    return line.toString();
  }

  @Override
  public Measures measures() {
    int crossed = 0;
    List<Long> waits = new ArrayList<>();
    for (List<Crossed> trips : cars.values()) {
      for (Crossed trip : trips) {
        if (trip.grantedNs >= 0) {
          waits.add(trip.grantedNs - trip.askedNs);
        }
        if (trip.leftNs >= 0) {
          crossed++;
        }
      }
    }
    return new Measures(cars.size(), crossed, waits);
  }

  @Override
  public List<Sample> samples() {
    List<Long> crossings = new ArrayList<>();
    for (List<Crossed> trips : cars.values()) {
      for (Crossed trip : trips) {
        if (trip.leftNs >= 0) {
          crossings.add(trip.leftNs);
        }
      }
    }
    return List.of(
        Sample.howLong(
            "wait from being registered to being granted all zones", measures().waitsNs()),
        Sample.when("crossings", crossings));
  }

  /** The trip that it is on, or was on last. */
  private Crossed car(RobotId robot) {
    List<Crossed> trips = trips(robot);
    return trips.get(trips.size() - 1);
  }

  private List<Crossed> trips(RobotId robot) {
    return cars.computeIfAbsent(robot, id -> new ArrayList<>(List.of(new Crossed())));
  }

  private static String seconds(long ns) {
    long tenths = Math.round(ns / NS_PER_S * 10);
    return tenths / 10 + "." + tenths % 10 + " s";
  }
}
