package org.starl.android.apk;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.function.Supplier;
import org.starl.apps.Request;
import org.starl.apps.intersection.IntersectionDemo;
import org.starl.sim.Simulation;
import org.starl.sim.TraceRecorder;

/** Simulates the paper's four cars (Figure 7), a tenth of their datagrams lost, and gives the trace. */
public final class CrossingTrace implements Supplier<byte[]> {

  private static final long SEED = 7;

  @Override
  public byte[] get() {
    IntersectionDemo demo = new IntersectionDemo();
    SortedMap<String, String> parameters = demo.defaults();
    parameters.put("scenario", "figure7");
    Request request = new Request(SEED, OptionalInt.empty(), parameters);
    Simulation.Builder simulation =
        demo.plan(request, demo.defaultSettings(request).set("messageLoss", "0.1").build())
            .simulation();
    ByteArrayOutputStream trace = new ByteArrayOutputStream();
    try (TraceRecorder recorder = new TraceRecorder(trace)) {
      simulation.observer(recorder).build().run();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return trace.toByteArray();
  }
}
