// The build that users of StarL expect. Beside it stands a Maven build (pom.xml) for networks that
// cannot fetch a Gradle distribution; the quality gates are there. A test compares the two.
rootProject.name = "starl"

dependencyResolutionManagement {
    repositories {
        mavenCentral()
    }
}

include(":starl-core")
include(":starl-primitives")
include(":starl-sim")
include(":starl-android")
include(":starl-apps")
include(":starl-android-app")
project(":starl-android-app").projectDir = rootDir.resolve("starl-android/app")
include(":starl-android-apk")
project(":starl-android-apk").projectDir = rootDir.resolve("starl-android/apk")
