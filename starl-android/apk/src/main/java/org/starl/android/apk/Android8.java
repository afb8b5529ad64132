package org.starl.android.apk;

import com.android.tools.r8.BackportedMethodList;
import com.android.tools.r8.BackportedMethodListCommand;
import com.android.tools.r8.CompilationFailedException;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.zip.GZIPInputStream;
import org.codehaus.mojo.animal_sniffer.Clazz;

/** The classes and members of Android 8 (API 26), from a list of the class path in animal-sniffer's form. */
final class Android8 {

  private static final String MATCH_EXCEPTION = "<init>(Ljava/lang/String;Ljava/lang/Throwable;)V";

  /** Not in D8's list, but D8 replaces these too. */
  private static final String OPTIONALS =
      String.join(
          "\n",
          "java/util/Optional#isEmpty()Z",
          "java/util/OptionalInt#isEmpty()Z",
          "java/util/OptionalLong#isEmpty()Z",
          "java/util/OptionalDouble#isEmpty()Z",
          "java/util/Optional#orElseThrow()Ljava/lang/Object;",
          "java/util/OptionalInt#orElseThrow()I",
          "java/util/OptionalLong#orElseThrow()J",
          "java/util/OptionalDouble#orElseThrow()D");

  private static final String PREFIX = "gummy-bears-api-" + Levels.MIN_SDK;

  private Android8() {}

  /** All of them, by name with slashes. */
  static SortedMap<String, Links.Shape> shapes(String classPath) throws ApkException, IOException {
    Path list = ClassPath.file(classPath, PREFIX);
    SortedMap<String, Links.Shape> shapes = new TreeMap<>();
    try (InputStream in = Files.newInputStream(list);
        ObjectInputStream objects = new ObjectInputStream(new GZIPInputStream(in))) {
      for (Clazz each = next(objects); each != null; each = next(objects)) {
        List<String> parents = new ArrayList<>(Arrays.asList(each.getSuperInterfaces()));
        if (each.getSuperClass() != null) {
          parents.add(each.getSuperClass());
        }
        shapes.put(each.getName(), new Links.Shape(parents, each.getSignatures()));
      }
    }
    return shapes;
  }

  /** The same, and what D8 replaces in code for this version of Android. */
  static SortedMap<String, Links.Shape> shapesBeforeD8(String classPath)
      throws ApkException, IOException {
    SortedMap<String, Links.Shape> shapes = shapes(classPath);
    shapes.put("java/lang/MatchException", new Links.Shape(List.of(), Set.of(MATCH_EXCEPTION)));
    StringBuilder lines = new StringBuilder();
    try {
      BackportedMethodList.run(
          BackportedMethodListCommand.builder()
              .setMinApiLevel(Levels.MIN_SDK, 0)
              .setConsumer((text, handler) -> lines.append(text).append("\n"))
              .build());
    } catch (CompilationFailedException e) {
      throw ApkException.failed("D8: " + e.getMessage());
    }
    lines.append(OPTIONALS);
    for (String line : lines.toString().split("\\R", -1)) {
      int end = line.indexOf('#');
      Links.Shape shape = end < 0 ? null : shapes.get(line.substring(0, end));
      if (shape != null) {
        Set<String> members = new TreeSet<>(shape.members());
        members.add(line.substring(end + 1));
        shapes.put(line.substring(0, end), new Links.Shape(shape.parents(), members));
      }
    }
    return shapes;
  }

  private static Clazz next(ObjectInputStream objects) throws IOException {
    try {
      return (Clazz) objects.readObject();
    } catch (ClassNotFoundException e) {
      throw new IOException("the list is not of animal-sniffer's form", e);
    }
  }
}
