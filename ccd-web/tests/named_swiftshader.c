// A Vulkan driver that passes everything on to lavapipe, but has SwiftShader's vendor and device.
//
// Chromium's WebGPU takes a driver without shared textures only if that is SwiftShader, and
// lavapipe shares none where there is no /dev/udmabuf. Kernels do not need them.

#include <dlfcn.h>
#include <stdint.h>
#include <string.h>

typedef void (*Function)(void);
typedef Function (*Get)(void *instance, const char *name);

static Function symbol(const char *name) {
    static void *driver;
    if (!driver) driver = dlopen(DRIVER, RTLD_NOW | RTLD_LOCAL);
    return driver ? (Function)dlsym(driver, name) : 0;
}

/* Words of VkPhysicalDeviceProperties: apiVersion, driverVersion, vendorID, deviceID. */
static void name(uint32_t *properties) {
    properties[2] = 0x1AE0;
    properties[3] = 0xC0DE;
}

static void (*of_device)(void *device, uint32_t *properties);
static void properties(void *device, uint32_t *out) {
    of_device(device, out);
    name(out);
}

/* VkPhysicalDeviceProperties2: type, pointer to the next structure, then the properties. */
static void (*of_device2)(void *device, unsigned char *out);
static void properties2(void *device, unsigned char *out) {
    of_device2(device, out);
    name((uint32_t *)(out + 16));
}

static Function get(const char *by, void *instance, const char *called) {
    Get ask = (Get)symbol(by);
    Function found = ask ? ask(instance, called) : 0;
    if (found && !strcmp(called, "vkGetPhysicalDeviceProperties")) {
        of_device = (void (*)(void *, uint32_t *))found;
        return (Function)properties;
    }
    if (found && !strncmp(called, "vkGetPhysicalDeviceProperties2", 30)) {
        of_device2 = (void (*)(void *, unsigned char *))found;
        return (Function)properties2;
    }
    return found;
}

/* What a loader asks of a driver. */
Function vk_icdGetInstanceProcAddr(void *instance, const char *called) {
    return get("vk_icdGetInstanceProcAddr", instance, called);
}

Function vk_icdGetPhysicalDeviceProcAddr(void *instance, const char *called) {
    return get("vk_icdGetPhysicalDeviceProcAddr", instance, called);
}

int vk_icdNegotiateLoaderICDInterfaceVersion(uint32_t *version) {
    typedef int (*Negotiate)(uint32_t *);
    Negotiate negotiate = (Negotiate)symbol("vk_icdNegotiateLoaderICDInterfaceVersion");
    return negotiate ? negotiate(version) : -9; /* VK_ERROR_INCOMPATIBLE_DRIVER */
}
