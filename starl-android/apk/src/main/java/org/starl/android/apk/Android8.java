package org.starl.android.apk;

import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.zip.GZIPInputStream;
import org.codehaus.mojo.animal_sniffer.Clazz;

/** The classes and members of Android 8 (API 26), from a list of the class path in animal-sniffer's form. */
final class Android8 {

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

  private static Clazz next(ObjectInputStream objects) throws IOException {
    try {
      return (Clazz) objects.readObject();
    } catch (ClassNotFoundException e) {
      throw new IOException("the list is not of animal-sniffer's form", e);
    }
  }
}
