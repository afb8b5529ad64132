package org.starl.android.apk;

import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Enumeration;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.Opcodes;

/**
 * Loads classes itself: what the given place has, from there, StarL's from nowhere else, and all others
 * as usual.
 */
final class OwnClasses extends ClassLoader {

  /** Gives the bytes of a class by its name with slashes, or null. */
  interface Place {
    byte[] bytes(String name) throws IOException;
  }

  /** Classes that no other loader may give: StarL's, its libraries' and those of projects. */
  private static final Pattern OURS =
      Pattern.compile("(org/starl|com/fasterxml|org/yaml|org/locationtech|myrobots)/.*");

  private final Place place;
  private final Path services;
  private final SortedSet<String> loaded = new TreeSet<>();

  OwnClasses(Place place) {
    this(place, null);
  }

  /**
   * @param services the file {@link Selection#SERVICES}; null for that of the class path
   */
  OwnClasses(Place place, Path services) {
    super(OwnClasses.class.getClassLoader());
    this.place = place;
    this.services = services;
  }

  @Override
  public Enumeration<URL> getResources(String name) throws IOException {
    return services != null && name.equals(Selection.SERVICES)
        ? Collections.enumeration(List.of(services.toUri().toURL()))
        : super.getResources(name);
  }

  /** One that loads what is compiled. */
  static OwnClasses compiled() {
    return new OwnClasses(OwnClasses::compiled);
  }

  /** The bytes of a class of StarL's or of a library, as javac made them. */
  static byte[] compiled(String name) throws IOException {
    if (!OURS.matcher(name).matches()) {
      return null;
    }
    try (InputStream in = OwnClasses.class.getClassLoader().getResourceAsStream(name + ".class")) {
      return in == null ? null : in.readAllBytes();
    }
  }

  /** Names, with slashes, of these classes that were loaded, and of all that share a file with these. */
  SortedSet<String> needed() throws IOException {
    SortedSet<String> needed = new TreeSet<>();
    for (String name : loaded) {
      String host = name.replaceFirst("\\$.*", "");
      needed.add(host);
      new ClassReader(place.bytes(host))
          .accept(
              new ClassVisitor(Opcodes.ASM9) {
                @Override
                public void visitNestMember(String member) {
                  needed.add(member);
                }
              },
              ClassReader.SKIP_CODE);
    }
    return needed;
  }

  @Override
  protected Class<?> loadClass(String name, boolean resolves) throws ClassNotFoundException {
    synchronized (getClassLoadingLock(name)) {
      Class<?> known = findLoadedClass(name);
      if (known != null) {
        return known;
      }
      String path = name.replace('.', '/');
      byte[] bytes = bytes(path);
      if (bytes != null) {
        loaded.add(path);
        return defineClass(name, bytes, 0, bytes.length);
      }
      if (OURS.matcher(path).matches()) {
        throw new ClassNotFoundException(name);
      }
      return super.loadClass(name, resolves);
    }
  }

  private byte[] bytes(String path) throws ClassNotFoundException {
    try {
      return place.bytes(path);
    } catch (IOException e) {
      throw new ClassNotFoundException(path, e);
    }
  }
}
