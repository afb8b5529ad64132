package org.starl.android.apk;

import java.io.Closeable;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Enumeration;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.jspecify.annotations.Nullable;

/** The files of a class path's folders and jars, by their names with slashes. */
final class ClassPath implements Closeable {

  /** A folder, or a jar, which is open. */
  private record Entry(Path path, @Nullable ZipFile jar, SortedSet<String> names) {

    byte[] bytes(String name) throws IOException {
      if (jar == null) {
        return Files.readAllBytes(path.resolve(name));
      }
      try (InputStream in = jar.getInputStream(jar.getEntry(name))) {
        return in.readAllBytes();
      }
    }
  }

  private final List<Entry> entries = new ArrayList<>();

  /** The first entry with each name. */
  private final SortedMap<String, Entry> first = new TreeMap<>();

  private ClassPath() {}

  /** Opens all entries but the jars whose names begin with {@code without}. */
  static ClassPath open(String classPath, String without) throws IOException {
    ClassPath opened = new ClassPath();
    try {
      for (String text : split(classPath)) {
        Path path = Path.of(text);
        if (Files.isDirectory(path)) {
          opened.add(new Entry(path, null, namesIn(path)));
        } else if (text.endsWith(".jar")
            && Files.exists(path)
            && !nameOf(path).startsWith(without)) {
          ZipFile jar = new ZipFile(path.toFile());
          opened.add(new Entry(path, jar, namesIn(jar)));
        }
      }
      return opened;
    } catch (IOException e) {
      opened.close();
      throw e;
    }
  }

  /**
   * The file of that name's beginning, on the class path or, as a JVM's lists have only jars, beside a
   * jar of it.
   *
   * @throws ApkException if there is none
   */
  static Path file(String classPath, String prefix) throws ApkException, IOException {
    List<Path> files = new ArrayList<>();
    SortedSet<Path> folders = new TreeSet<>();
    for (String entry : split(classPath)) {
      Path path = Path.of(entry);
      files.add(path);
      Path folder = path.getParent();
      if (entry.endsWith(".jar") && folder != null && Files.isDirectory(folder)) {
        folders.add(folder);
      }
    }
    for (Path folder : folders) {
      try (Stream<Path> beside = Files.list(folder)) {
        beside.forEach(files::add);
      }
    }
    for (Path file : files) {
      if (nameOf(file).startsWith(prefix)) {
        return file;
      }
    }
    throw ApkException.missing("no " + prefix + "* on the class path: run './starl apk'");
  }

  /** All names. */
  SortedSet<String> names() {
    return new TreeSet<>(first.keySet());
  }

  /** The first file of that name; null if there is none. */
  byte @Nullable [] bytes(String name) throws IOException {
    Entry entry = first.get(name);
    return entry == null ? null : entry.bytes(name);
  }

  /** All files of that name, each with the names beside it, in the order of the class path. */
  SortedMap<Integer, byte[]> all(String name) throws IOException {
    SortedMap<Integer, byte[]> all = new TreeMap<>();
    for (int i = 0; i < entries.size(); i++) {
      if (entries.get(i).names().contains(name)) {
        all.put(i, entries.get(i).bytes(name));
      }
    }
    return all;
  }

  /** The names in the entry of that number. */
  SortedSet<String> names(int entry) {
    return entries.get(entry).names();
  }

  @Override
  public void close() throws IOException {
    for (Entry entry : entries) {
      if (entry.jar() != null) {
        entry.jar().close();
      }
    }
  }

  private void add(Entry entry) {
    entries.add(entry);
    entry.names().forEach(name -> first.putIfAbsent(name, entry));
  }

  private static String nameOf(Path path) {
    return String.valueOf(path.getFileName());
  }

  private static List<String> split(String classPath) {
    return List.of(classPath.split(Pattern.quote(File.pathSeparator), -1));
  }

  private static SortedSet<String> namesIn(Path folder) throws IOException {
    SortedSet<String> names = new TreeSet<>();
    try (Stream<Path> files = Files.walk(folder)) {
      files
          .filter(Files::isRegularFile)
          .forEach(file ->
              names.add(folder.relativize(file).toString().replace(File.separatorChar, '/')));
    }
    return names;
  }

  private static SortedSet<String> namesIn(ZipFile jar) {
    SortedSet<String> names = new TreeSet<>();
    for (Enumeration<? extends ZipEntry> all = jar.entries(); all.hasMoreElements(); ) {
      ZipEntry entry = all.nextElement();
      if (!entry.isDirectory()) {
        names.add(entry.getName());
      }
    }
    return names;
  }
}
