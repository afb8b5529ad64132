package org.starl.robot.serial;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.robot.create.ByteLink;

/** A port that a process opens first while it ends, as to stop the wheels of a killed guard. */
@Tag("realtime")
class SerialShutdownTest {

  /** Opens the port in a shutdown hook. */
  static final class Ending {
    private Ending() {}

    public static void main(String[] args) {
      ByteLink.Source port = SerialLink.at(args[0], 115_200);
      Runtime.getRuntime().addShutdownHook(new Thread(() -> open(port), "end"));
    }

    private static void open(ByteLink.Source port) {
      try {
        port.open().close();
      } catch (IOException e) {
        System.out.println(e.getMessage());
      }
    }
  }

  @Test
  void aPortCanBeOpenedDuringTheShutdown() throws Exception {
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                Ending.class.getName(),
                "/dev/null")
            .redirectErrorStream(true)
            .start();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    process.waitFor();
    // It is no serial port; the attempt to open it gets that far.
    assertThat(said).contains("/dev/null: cannot be opened");
  }
}
