package org.starl.android.apk;

import java.io.File;
import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Collections;
import java.util.Enumeration;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** Selects the classes for a phone: no simulator, no desktop, no command line. */
final class Selection {

  /** Core, primitives, the real platform without its serial ports, apps' logic, the phone's app. */
  private static final Pattern OURS =
      Pattern.compile(
          "org/starl/([^/]+|(body|comms|geometry|gvh|id|input|motion|platform|random|spec|time|trace)/.+"
              + "|robot/(?!serial/).+|(primitives|android/app)/.+|apps/(.+/)?logic/.+)\\.class");

  /** JTS's geometry without drawing and KML; Jackson's core and YAML parser without data binding. */
  private static final Pattern LIBRARIES =
      Pattern.compile(
          "org/locationtech/jts/(?!awt/|io/kml/|util/TestBuilderProxy).+\\.class"
              + "|com/fasterxml/jackson/(core|dataformat/yaml(?!/YAMLMapper))/.+\\.class"
              + "|org/yaml/snakeyaml/(LoaderOptions|DumperOptions\\b.*"
              + "|(comments|emitter|error|events|internal|nodes|parser|reader|resolver|scanner|serializer|tokens|util)/.+"
              + "|external/.+|inspector/.+)\\.class");

  private Selection() {}

  static boolean takes(String name) {
    return !name.endsWith("package-info.class")
        && (OURS.matcher(name).matches() || LIBRARIES.matcher(name).matches());
  }

  /** The bytes of every class of {@code classPath} that a phone takes, by name. */
  static SortedMap<String, byte[]> classes(String classPath) throws IOException {
    SortedMap<String, byte[]> found = new TreeMap<>();
    for (String entry : entries(classPath)) {
      Path path = Path.of(entry);
      if (Files.isDirectory(path)) {
        addFolder(path, Selection::takes, found);
      } else if (entry.endsWith(".jar") && Files.exists(path)) {
        addJar(path, Selection::takes, found);
      }
    }
    return Collections.unmodifiableSortedMap(found);
  }

  /** The jar of that name's beginning, or null. */
  static Path jar(String classPath, String prefix) throws ApkException {
    for (String entry : entries(classPath)) {
      Path path = Path.of(entry);
      if (path.getFileName() != null && path.getFileName().toString().startsWith(prefix)) {
        return path;
      }
    }
    throw ApkException.missing("no " + prefix + "*.jar on the class path: run './starl apk'");
  }

  private static List<String> entries(String classPath) {
    return List.of(classPath.split(Pattern.quote(File.pathSeparator), -1));
  }

  private static void addFolder(
      Path folder, Predicate<String> isWanted, SortedMap<String, byte[]> found) throws IOException {
    Files.walkFileTree(
        folder,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
              throws IOException {
            String name = folder.relativize(file).toString().replace(File.separatorChar, '/');
            if (isWanted.test(name)) {
              found.putIfAbsent(name, Files.readAllBytes(file));
            }
            return FileVisitResult.CONTINUE;
          }
        });
  }

  private static void addJar(Path jar, Predicate<String> isWanted, SortedMap<String, byte[]> found)
      throws IOException {
    try (ZipFile zip = new ZipFile(jar.toFile())) {
      for (Enumeration<? extends ZipEntry> all = zip.entries(); all.hasMoreElements(); ) {
        ZipEntry entry = all.nextElement();
        if (isWanted.test(entry.getName()) && !found.containsKey(entry.getName())) {
          found.put(entry.getName(), zip.getInputStream(entry).readAllBytes());
        }
      }
    }
  }
}
