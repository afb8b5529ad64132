package org.starl.processes;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.sim.check.MalformedBytes;

/** Any line as an order to a robot's process: an order that is told as it was, or refused. */
public class OrderFuzzTest {

  public static void fuzzerTestOneInput(byte[] input) {
    String line = new String(input, StandardCharsets.UTF_8);
    Order order;
    try {
      order = Order.parse(line);
    } catch (IllegalArgumentException refused) {
      require(String.valueOf(refused.getMessage()).startsWith("no order: '"), "no line");
      return;
    }
    require(order.equals(Order.parse(order.toString())), "another order");
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }

  @Test
  void aLineIsAnOrderOrRefused() {
    List<byte[]> samples =
        List.of("begin -123456789", "peer bot1 4747", "go", "place", "peer bot1", "begin ").stream()
            .map(line -> line.getBytes(StandardCharsets.UTF_8))
            .toList();
    MalformedBytes.feed(samples, OrderFuzzTest::fuzzerTestOneInput);
  }
}
