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
    Class<?> define(String name, byte[] bytes) {
      return defineClass(name, bytes, 0, bytes.length);
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
    Class<?> probed = new Loader().define(Sample.class.getName(), probes.probed(bytes()));
    assertThat(probes.neverRun()).singleElement().asString().startsWith("ProbesTest.java: 7 of 7");
    assertThat(probed.getMethod("sum", int.class).invoke(null, 4)).isEqualTo(6);
    assertThat(probes.neverRun()).containsExactly("ProbesTest.java: 2 of 7 lines: 12, 17");
    assertThat(probes.isRun("ProbesTest.java", 19)).isTrue();
  }

  /** Its line begins with an object, of which a frame says that it has no value yet. */
  public static final class Chosen {
    public static String text(int number) {
      return new StringBuilder(number > 2 ? "many" : "few").toString();
    }
  }

  @Test
  void aLineMayBeginWithANewObject() throws Exception {
    Probes probes = new Probes();
    byte[] bytes;
    try (InputStream in = Chosen.class.getResourceAsStream("ProbesTest$Chosen.class")) {
      bytes = probes.probed(in.readAllBytes());
    }
    Class<?> probed = new Loader().define(Chosen.class.getName(), bytes);
    assertThat(probed.getMethod("text", int.class).invoke(null, 3)).isEqualTo("many");
  }
}
