package org.starl.cli.mutants;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import org.junit.jupiter.api.Test;

class ProbesTest {

  /** Has jumps to the beginnings of lines, where a frame stands. */
  public static final class Sample {
    public static int sum(int below) {
      int sum = 0;
      for (int i = 0; i < below; i++) {
        if (i == 100) {
          sum += 1_000; // not run
        }
        sum += i;
      }
      return sum;
    }
  }

  private static final class Loader extends ClassLoader {
    Class<?> define(byte[] bytes) {
      return defineClass(Sample.class.getName(), bytes, 0, bytes.length);
    }
  }

  private static byte[] bytes() throws IOException {
    try (InputStream in = Sample.class.getResourceAsStream("ProbesTest$Sample.class")) {
      return in.readAllBytes();
    }
  }

  @Test
  void aLineThatNoRunReachesIsNamed() throws Exception {
    Probes probes = new Probes();
    Class<?> probed = new Loader().define(probes.probed(bytes()));
    assertThat(probes.neverRun()).singleElement().asString().startsWith("ProbesTest.java: 7 of 7");
    assertThat(probed.getMethod("sum", int.class).invoke(null, 4)).isEqualTo(6);
    assertThat(probes.neverRun()).containsExactly("ProbesTest.java: 2 of 7 lines: 12, 17");
    assertThat(probes.isRun("ProbesTest.java", 19)).isTrue();
  }
}
