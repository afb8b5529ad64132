package org.starl.sim.world;

import java.util.ArrayList;
import java.util.List;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

/** Keeps all events. */
public final class TestTrace implements TraceSink {

  private final List<TraceEvent> events = new ArrayList<>();

  @Override
  public boolean isOn() {
    return true;
  }

  @Override
  public void record(TraceEvent event) {
    events.add(event);
  }

  public List<TraceEvent> events() {
    return events;
  }

  public <T extends TraceEvent> List<T> of(Class<T> kind) {
    List<T> found = new ArrayList<>();
    for (TraceEvent event : events) {
      if (kind.isInstance(event)) {
        found.add(kind.cast(event));
      }
    }
    return found;
  }
}
