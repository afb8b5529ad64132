package org.starl.sim.export;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;

/** A layout of Foxglove for the topics of {@link FoxgloveRecorder}: floor, log, plot, messages. */
public final class FoxgloveLayout {

  private FoxgloveLayout() {}

  /** The file that Foxglove imports, in UTF-8. */
  public static byte[] json() {
    try (InputStream in = FoxgloveLayout.class.getResourceAsStream("layout.json")) {
      if (in == null) {
        throw new IllegalStateException("no resource layout.json");
      }
      return in.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
