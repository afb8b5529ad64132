package org.starl.cli.report;

import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.primitives.Phases;
import org.starl.primitives.monitor.PrimitivePhases;
import org.starl.sim.SimObserver;
import org.starl.trace.MessageText;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/** Counts the deliveries of a run. It sees each message of a run, so it avoids work for each. */
public final class DeliveryCounter implements SimObserver {

  private static final String APP = "app";
  private static final String LOCATION = "location";

  private static final SortedMap<String, Phases> PRIMITIVES = new TreeMap<>();

  static {
    PrimitivePhases.ALL.forEach(phases -> PRIMITIVES.put(phases.primitive(), phases));
  }

  private final Deliveries deliveries = new Deliveries();
  private final SortedMap<RobotId, Robot> robots = new TreeMap<>();

  /** An instance of a primitive on a robot. */
  private static final class Instance {
    private final Phases.@Nullable Step step;
    private String phase;

    Instance(@Nullable Phases phases) {
      step = phases == null ? null : phases.steps().get();
      phase = phases == null ? Deliveries.NO_PHASE : phases.first();
    }
  }

  /** A robot's program, from its start to its crash. */
  private final class Robot {
    private final SortedMap<String, Instance> instances = new TreeMap<>();

    /** The counts of each channel in the present phase and location. */
    private final SortedMap<String, SortedMap<String, Long>> present = new TreeMap<>();

    private String location = Deliveries.NO_LOCATION;

    Instance instance(String source) {
      Instance instance = instances.get(source);
      if (instance == null) {
        instance = new Instance(PRIMITIVES.get(primitive(source)));
        instances.put(source, instance);
      }
      return instance;
    }

    void changed(String source, TraceEvent event) {
      Instance instance = instance(source);
      if (instance.step != null) {
        String after = instance.step.after(instance.phase, event);
        if (!after.equals(instance.phase)) {
          instance.phase = after;
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
        String channel = event.channel();
        int slash = channel.indexOf('/');
        String source = primitive(channel) + (slash < 0 ? "" : channel.substring(slash));
        String kind = slash < 0 ? channel : channel.substring(0, slash);
        types = deliveries.in(kind, location, instance(source).phase);
        present.put(channel, types);
      }
      types.merge(MessageText.type(event.message()), 1L, Long::sum);
    }
  }

  /** The part before the instance, and before the part of a primitive that has its own channel. */
  private static String primitive(String source) {
    int slash = source.indexOf('/');
    String kind = slash < 0 ? source : source.substring(0, slash);
    int dot = kind.indexOf('.');
    return dot < 0 ? kind : kind.substring(0, dot);
  }

  @Override
  public void observed(TraceEvent event) {
    if (event instanceof TraceEvent.Delivered delivered) {
      robot(event).delivered(delivered);
    } else if (event instanceof TraceEvent.Action action) {
      robot(event).changed(action.source(), event);
    } else if (event instanceof TraceEvent.Variable variable) {
      if (!variable.source().equals(APP)) {
        robot(event).changed(variable.source(), event);
      } else if (variable.name().equals(LOCATION)) {
        robot(event).moveTo(variable.value());
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
