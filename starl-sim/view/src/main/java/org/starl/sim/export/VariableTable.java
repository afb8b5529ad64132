package org.starl.sim.export;

import java.io.OutputStream;
import org.starl.trace.TraceEvent;

/** Writes variables as a table: one row for each new value, the first one included. */
public final class VariableTable extends CsvTable {

  public VariableTable(OutputStream out) {
    super(out, "time_s", "robot", "source", "name", "value");
  }

  @Override
  public void observed(TraceEvent event) {
    if (event instanceof TraceEvent.Variable v) {
      row(seconds(v.timeNs()), v.robot(), v.source(), v.name(), v.value());
    }
  }
}
