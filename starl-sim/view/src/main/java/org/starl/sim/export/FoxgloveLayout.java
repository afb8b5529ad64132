package org.starl.sim.export;

import java.nio.charset.StandardCharsets;
import org.starl.input.TextFile;

/** A layout of Foxglove for the topics of {@link FoxgloveRecorder}: floor, log, plot, messages. */
public final class FoxgloveLayout {

  private FoxgloveLayout() {}

  /** The file that Foxglove imports, in UTF-8. */
  public static byte[] json() {
    return TextFile.resource(FoxgloveLayout.class, "layout.json").getBytes(StandardCharsets.UTF_8);
  }
}
