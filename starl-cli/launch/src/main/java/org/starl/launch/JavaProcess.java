package org.starl.launch;

import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** Command lines of Java processes: the same JVM and class path as this process. */
public final class JavaProcess {

  /** Starts fast and leaves the processors to other processes. */
  private static final List<String> OPTIONS =
      List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "--enable-native-access=ALL-UNNAMED");

  private JavaProcess() {}

  /**
   * A command line.
   *
   * @param heapMb largest heap
   * @param main the class with the main method
   */
  public static List<String> command(int heapMb, String main, List<String> args) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(OPTIONS);
    command.addAll(List.of("-Xmx" + heapMb + "m", "-cp", absoluteClassPath(), main));
    command.addAll(args);
    return command;
  }

  private static String absoluteClassPath() {
    return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator, -1))
        .map(entry -> Path.of(entry).toAbsolutePath().toString())
        .collect(Collectors.joining(File.pathSeparator));
  }
}
