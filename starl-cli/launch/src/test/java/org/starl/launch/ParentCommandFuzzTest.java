package org.starl.launch;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.sim.check.MalformedBytes;

/**
 * Any line as a command to a robot's process: a command that is written as it was read, or refused.
 */
public class ParentCommandFuzzTest {

  public static void fuzzerTestOneInput(byte[] input) {
    String line = new String(input, StandardCharsets.UTF_8);
    ParentCommand command;
    try {
      command = ParentCommand.parse(line);
    } catch (IllegalArgumentException refused) {
      require(String.valueOf(refused.getMessage()).startsWith("not a command: '"), "no line");
      return;
    }
    require(command.equals(ParentCommand.parse(command.toString())), "another command");
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }

  @Test
  void aLineIsACommandOrRefused() {
    List<byte[]> samples =
        List.of("begin -123456789", "go bot1 4747 bot2 4748", "go", "place", "go bot1", "begin ")
            .stream()
            .map(line -> line.getBytes(StandardCharsets.UTF_8))
            .toList();
    MalformedBytes.feed(samples, ParentCommandFuzzTest::fuzzerTestOneInput);
  }
}
