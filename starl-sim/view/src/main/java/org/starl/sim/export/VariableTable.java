package org.starl.sim.export;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import org.starl.sim.SimObserver;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/** Writes variables as a table: one line whenever one has a new value, the first one included. */
public final class VariableTable implements SimObserver, Closeable {

  private final CsvFile file;

  public VariableTable(OutputStream out) {
    file = new CsvFile(out);
  }

  @Override
  public void started(TraceHeader header) {
    file.row("time_s", "robot", "source", "name", "value");
  }

  @Override
  public void observed(TraceEvent event) {
    if (event instanceof TraceEvent.Variable variable) {
      file.row(
          CsvFile.seconds(variable.timeNs()),
          variable.robot(),
          variable.source(),
          variable.name(),
          variable.value());
    }
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
