package org.starl.cli.report;

import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.primitives.Phases;
import org.starl.primitives.monitor.PrimitivePhases;
import org.starl.sim.SimObserver;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/** Counts the deliveries of a run. It sees each message of a run, so it avoids work for each. */
public final class DeliveryCounter implements SimObserver {

  private static final String LOCATION = "location";

  private static final SortedMap<String, Phases> PRIMITIVES = new TreeMap<>();

  static {
    PrimitivePhases.ALL.forEach(phases -> PRIMITIVES.put(phases.primitive(), phases));
  }

  private final Deliveries deliveries = new Deliveries();
  private final SortedMap<RobotId, Robot> robots = new TreeMap<>();

  /** An instance of a primitive on a robot. */
  private static final class Part {
    private final Phases.@Nullable Step step;
    private String phase;

    Part(@Nullable Phases phases) {
      step = phases == null ? null : phases.steps().get();
      phase = phases == null ? Deliveries.NO_PHASE : phases.first();
    }
  }

  /** A robot's program, from its start to its crash. */
  private final class Robot {
    private final SortedMap<Instance, Part> parts = new TreeMap<>();

    /** The counts of each channel in the present phase and location. */
    private final SortedMap<Instance, SortedMap<String, Long>> present = new TreeMap<>();

    private String location = Deliveries.NO_LOCATION;

    Part part(Instance source) {
      Part part = parts.get(source);
      if (part == null) {
        part = new Part(PRIMITIVES.get(source.primitive()));
        parts.put(source, part);
      }
      return part;
    }

    void changed(Instance source, TraceEvent event) {
      Part part = part(source);
      if (part.step != null) {
        String after = part.step.after(part.phase, event);
        if (!after.equals(part.phase)) {
          part.phase = after;
          present.clear();
        }
      }
    }

    void moveTo(String newLocation) {
      location = newLocation;
      present.clear();
    }

    void delivered(TraceEvent.Delivered event) {
      SortedMap<String, Long> types = present.get(event.channel());
      if (types == null) {
        Instance channel = event.channel();
        types = deliveries.in(channel.kind(), location, part(channel.owner()).phase);
        present.put(channel, types);
      }
      types.merge(event.message().getClass().getSimpleName(), 1L, Long::sum);
    }
  }

  @Override
  public void observed(TraceEvent event) {
    if (event instanceof TraceEvent.Delivered delivered) {
      robot(event).delivered(delivered);
    } else if (event instanceof TraceEvent.Action action) {
      robot(event).changed(action.source(), event);
    } else if (event instanceof TraceEvent.Variable variable) {
      if (!variable.source().equals(Instance.APP)) {
        robot(event).changed(variable.source(), event);
      } else if (variable.name().equals(LOCATION)) {
        robot(event).moveTo(variable.value().toString());
      }
    } else if (event instanceof Fault fault && fault.name().equals(Fault.CRASH)) {
      robots.remove(fault.robot());
    }
  }

  private Robot robot(TraceEvent event) {
    Robot robot = robots.get(event.robot());
    if (robot == null) {
      robot = new Robot();
      robots.put(event.robot(), robot);
    }
    return robot;
  }

  Deliveries deliveries() {
    return deliveries;
  }
}
