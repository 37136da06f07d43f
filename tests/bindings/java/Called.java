// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs a program under the debugger's interface and writes which public members of org.jalon returned to their caller: those
// that threw are not among them.
//   java Called.java FOLDER_OF_CLASSES CLASS_PATH OUT_FOLDER "MAIN ARGUMENT ..." [OPTION ...]
// OUT_FOLDER/public.txt: what there is; OUT_FOLDER/called.txt: what returned.
import com.sun.jdi.Bootstrap;
import com.sun.jdi.Method;
import com.sun.jdi.VMDisconnectedException;
import com.sun.jdi.VirtualMachine;
import com.sun.jdi.connect.Connector;
import com.sun.jdi.connect.LaunchingConnector;
import com.sun.jdi.event.Event;
import com.sun.jdi.event.EventSet;
import com.sun.jdi.event.MethodExitEvent;
import com.sun.jdi.event.VMDisconnectEvent;
import com.sun.jdi.request.EventRequest;
import com.sun.jdi.request.MethodExitRequest;
import java.io.InputStream;
import java.lang.reflect.Executable;
import java.lang.reflect.Modifier;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

class Called {
  private static String plain(String type) {
    return type.replaceAll("[\\w.]*[.$](\\w+)", "$1");
  }

  /** "Cloud.select(boolean[], Task)"; a constructor has the name of its class twice. */
  private static String text(String type, String name, Stream<String> arguments) {
    return plain(type) + "." + (name.equals("<init>") ? plain(type) : plain(name)) + "("
        + arguments.map(Called::plain).collect(Collectors.joining(", ")) + ")";
  }

  /** The public members of the public classes of the folder, as text; classes gets the names of those classes. */
  private static Set<String> members(Path folder, Set<String> classes) throws Exception {
    final Set<String> members = new TreeSet<>();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()}); Stream<Path> files = Files.list(
        folder.resolve("org/jalon"))) {
      for (Path file : (Iterable<Path>) files.sorted()::iterator) {
        final String name = "org.jalon." + file.getFileName().toString().replace(".class", "");
        final Class<?> type = Class.forName(name, false, loader);
        if (!Modifier.isPublic(type.getModifiers()) || type.isInterface()) {
          continue;
        }
        classes.add(name);
        final Stream<Executable> all = Stream.concat(Stream.of(type.getDeclaredMethods()), Stream.of(type.getDeclaredConstructors()));
        all.filter(member -> Modifier.isPublic(member.getModifiers()) && !Modifier.isAbstract(member.getModifiers())
            && !member.isSynthetic()).forEach(member -> members.add(text(name, member.getName(),
                Stream.of(member.getParameterTypes()).map(Class::getTypeName))));
      }
    }
    return members;
  }

  private static VirtualMachine launch(String classPath, String main, List<String> options) throws Exception {
    final LaunchingConnector connector = Bootstrap.virtualMachineManager().defaultConnector();
    final Map<String, Connector.Argument> arguments = connector.defaultArguments();
    arguments.get("main").setValue(main);
    arguments.get("options").setValue("-cp " + classPath + " " + String.join(" ", options));
    return connector.launch(arguments);
  }

  private static void drain(InputStream from) {
    final Thread thread = new Thread(() -> {
      try {
        from.transferTo(System.out);
      } catch (java.io.IOException end) {
        System.out.flush();
      }
    });
    thread.start();
  }

  /** One request: each is asked about every method of the whole machine that returns. */
  private static Set<String> called(VirtualMachine machine, Set<String> classes) throws InterruptedException {
    final MethodExitRequest request = machine.eventRequestManager().createMethodExitRequest();
    request.addClassFilter("org.jalon.*");
    request.addClassExclusionFilter("org.jalon.JalonJNI");
    request.setSuspendPolicy(EventRequest.SUSPEND_NONE);
    request.enable();
    final Set<Method> methods = new HashSet<>();
    final Set<String> called = new TreeSet<>();
    machine.resume();
    try {
      while (true) {
        final EventSet events = machine.eventQueue().remove();
        for (Event event : events) {
          if (event instanceof VMDisconnectEvent) {
            return called;
          }
          if (event instanceof MethodExitEvent && methods.add(((MethodExitEvent) event).method())) {
            final Method method = ((MethodExitEvent) event).method();
            if (classes.contains(method.declaringType().name())) {
              called.add(text(method.declaringType().name(), method.name(), method.argumentTypeNames().stream()));
            }
          }
        }
      }
    } catch (VMDisconnectedException end) {
      return called;
    }
  }

  public static void main(String[] given) throws Exception {
    final Path out = Files.createDirectories(Path.of(given[2]));
    final Set<String> classes = new TreeSet<>();
    Files.write(out.resolve("public.txt"), members(Path.of(given[0]), classes));
    final VirtualMachine machine = launch(given[1], given[3], List.of(given).subList(4, given.length));
    drain(machine.process().getInputStream());
    drain(machine.process().getErrorStream());
    Files.write(out.resolve("called.txt"), called(machine, classes));
    System.exit(machine.process().waitFor());
  }
}
