package org.starl.primitives.mutex;

import java.util.List;
import java.util.TreeSet;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/** A request of the mutex, written to bytes and read from them. */
@State(Scope.Thread)
public class CodecBenchmark {

  private static final int DATAGRAM_BYTES = 1200;

  private final byte[] buffer = new byte[DATAGRAM_BYTES];
  private final MutexMessage request =
      new MutexMessage.Req(
          ProcessId.first(new RobotId("bot0"), 1),
          ProcessId.first(new RobotId("bot1"), 1),
          7,
          3,
          123_456,
          new TreeSet<>(List.of("NE", "NW", "SW")));
  private final byte[] written = WireWriter.toBytes(out -> MutexMessage.SHAPE.write(request, out));

  /** Writes it. */
  @Benchmark
  public int write() {
    WireWriter out = new WireWriter(buffer);
    MutexMessage.SHAPE.write(request, out);
    return out.length();
  }

  /** Reads it. */
  @Benchmark
  public MutexMessage read() {
    return MutexMessage.SHAPE.read(new WireReader(written));
  }
}
